"""The studio: one gear in the browser, every number of it live. Widgets only; all figures come from the packages below.

Needs the extra ``studio`` (NiceGUI).
"""

from strainwave.studio.session import Session

__all__ = ["Session"]
