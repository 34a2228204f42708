"""A document for the review of designs: one self-contained page, and the same on paper (extra ``report``)."""

from strainwave.report.chapter import Chapter
from strainwave.report.document import Document
from strainwave.report.provenance import Provenance
from strainwave.report.report_file import write_report

__all__ = ["Chapter", "Document", "Provenance", "write_report"]
