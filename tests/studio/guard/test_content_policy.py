"""What a page of the studio may do in the browser."""

from __future__ import annotations

import re

import pytest

from strainwave.studio.guard import Access
from tests.studio.guard.asking import HOME, OPEN, SCRIPTS, asked


def test_every_script_of_a_page_is_marked_anew_and_nothing_else() -> None:
    marks = set()
    for _ in range(3):
        answer = asked(HOME, "/")
        nonce = re.search(r"'nonce-([\w-]{16,})'", answer.headers["content-security-policy"])
        assert nonce is not None
        assert answer.text == SCRIPTS.replace("<script", f'<script nonce="{nonce[1]}"')
        assert len(answer.content) == int(answer.headers["content-length"])
        marks.add(nonce[1])
    assert len(marks) == 3


@pytest.mark.parametrize("path", ["/", "/static.js", "/framed"])
def test_every_answer_says_what_it_may(path: str) -> None:
    headers = asked(HOME, path).headers
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["x-frame-options"] == "SAMEORIGIN"
    assert headers["cross-origin-resource-policy"] == "same-origin"
    assert "access-control-allow-origin" not in headers


def test_scripts_come_from_here_and_nothing_from_elsewhere() -> None:
    policy = dict(part.split(" ", 1) for part in asked(HOME, "/").headers["content-security-policy"].split("; "))
    assert policy["default-src"] == "'none'"
    assert "'unsafe-inline'" not in policy["script-src"]
    assert policy["frame-ancestors"] == "'self'"
    assert not any(re.search(r"https?:|\*", sources) for sources in policy.values())


def test_an_answer_with_a_policy_of_its_own_keeps_it() -> None:
    answer = asked(HOME, "/framed")
    assert answer.headers["content-security-policy"] == "sandbox"
    assert answer.text == SCRIPTS


@pytest.mark.parametrize(("access", "coding"), [(HOME, None), (OPEN, "gzip")])
def test_what_goes_over_a_network_is_packed_after_it_is_marked(access: Access, coding: str | None) -> None:
    answer = asked(access, "/", headers={"cookie": f"{OPEN.cookie}={OPEN.pass_}", "accept-encoding": "gzip"})
    assert answer.headers.get("content-encoding") == coding
    assert answer.text.count("nonce=") == 2
