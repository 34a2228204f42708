"""The manifest of an exploration: the plan in full and the chunks it falls into, as JSON for any reader."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from strainwave.design.keys import leaves
from strainwave.errors import StrainwaveError, shown
from strainwave.studies.exploration.plan import Plan

MANIFEST = "manifest.json"
CHUNKS = "chunks"
KIND = "strainwave exploration"
MOST_DIFFERENCES = 3


def manifest_of(plan: Plan) -> str:
    """The text of the manifest. Chunks are finished when their files are there; the list says which there will be."""
    rows = [plan.rows_of(chunk) for chunk in range(plan.chunks)]
    record = {
        "kind": KIND,
        "schema_version": 1,
        "study": plan.study,
        "plan": plan.as_dict(),
        "generators": [
            {"label": each.label, "wave_generator": each.design.to_dict()["wave_generator"]} for each in plan.categories
        ],
        "parameters": [
            {"key": each.key, "unit": each.unit, "low": each.low, "high": each.high} for each in plan.parameters
        ],
        "figures": list(plan.columns),
        "chunks": [
            {"file": f"{CHUNKS}/{chunk_name(chunk)}", "first_sample": each.start, "rows": len(each)}
            for chunk, each in enumerate(rows)
        ],
    }
    return json.dumps(record, indent=1, ensure_ascii=False) + "\n"


def chunk_name(chunk: int) -> str:
    """The name of a chunk's file in the folder ``CHUNKS``."""
    return f"chunk-{chunk:06d}.parquet"


def plan_in(folder: Path) -> Plan:
    """The plan that a folder holds; ``StrainwaveError`` where it holds none, or one that was changed."""
    path = folder / MANIFEST
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise StrainwaveError(f"{folder}: is no folder of an exploration: there is no {MANIFEST}") from None
    except (OSError, ValueError) as error:
        raise StrainwaveError(f"{path}: cannot be read: {error}") from None
    if not isinstance(record, dict) or record.get("kind") != KIND:
        raise StrainwaveError(f"{path}: is not the manifest of an exploration")
    try:
        plan = Plan.from_dict(record["plan"])
        same = plan.study == record["study"]
    except (KeyError, TypeError, ValueError) as error:
        raise StrainwaveError(f"{path}: is damaged: {error}") from None
    if not same:
        raise StrainwaveError(f"{path}: was changed after the study began; its rows answer another question")
    return plan


def what_differs(there: Plan, here: Plan) -> str:
    """What two plans do not have in common, in words."""
    ours, theirs = (dict(leaves(plan.as_dict())) for plan in (here, there))
    keys = [key for key in {**theirs, **ours} if theirs.get(key) != ours.get(key)]
    found = [f"{key} is {_said(theirs, key)} there and {_said(ours, key)} here" for key in keys[:MOST_DIFFERENCES]]
    more = len(keys) - len(found)
    return ", ".join([*found, f"{more} more"] if more else found)


def _said(values: dict[str, Any], key: str) -> str:
    return shown(values[key]) if values.get(key) is not None else "not given"
