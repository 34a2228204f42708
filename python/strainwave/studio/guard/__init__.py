"""What stands between the network and the studio: who may speak to it, how much may be said, what a page may do."""

from strainwave.studio.guard.access import Access
from strainwave.studio.guard.guarded import guarded

__all__ = ["Access", "guarded"]
