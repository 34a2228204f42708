"""The studies as tasks of jobs: plain data in and out, no widgets."""
