"""Who may speak to the studio."""

from __future__ import annotations

import pytest
from starlette.datastructures import Headers

from strainwave.errors import StrainwaveError
from strainwave.studio.guard.access import Access, checked_token, is_loopback

HOME = Access("127.0.0.1", 8080, None)
OPEN = Access("0.0.0.0", 8080, "a-token-of-the-user")


@pytest.mark.parametrize("host", ["127.0.0.1", "127.0.0.2", "::1", "localhost"])
def test_loopback_needs_no_token(host: str) -> None:
    assert is_loopback(host)
    assert checked_token(host, None) is None


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "192.0.2.1", "localhost.example.com", "127.0.0.1.example.com", ""])
def test_other_addresses_get_a_new_one_each_time(host: str) -> None:
    assert not is_loopback(host)
    one, other = checked_token(host, None), checked_token(host, None)
    assert one is not None
    assert len(one) >= 24
    assert one != other


@pytest.mark.parametrize(
    "token", ["", "fifteen-letters", "sixteen letters!", "ein-Schlüssel-mit-Umlaut", "a&b=c&d=e&f=g&h=i"]
)
def test_a_poor_token_is_refused(token: str) -> None:
    with pytest.raises(StrainwaveError, match="at least 16 characters"):
        checked_token("127.0.0.1", token)


@pytest.mark.parametrize("host", ["127.0.0.1:8080", "localhost:8080", "[::1]:8080"])
def test_own_names_are_answered(host: str) -> None:
    assert HOME.refusal(Headers({"host": host, "origin": f"http://{host}"}), "http") is None


@pytest.mark.parametrize(
    "host", ["", "evil.example", "evil.example:8080", "127.0.0.1", "127.0.0.1:8081", "localhost:8080.evil.example"]
)
def test_other_names_are_not(host: str) -> None:
    """A name of somebody else's that leads to 127.0.0.1 (DNS rebinding)."""
    assert HOME.refusal(Headers({"host": host}), "http") == "This studio answers at 127.0.0.1:8080 only."


@pytest.mark.parametrize(
    "origin",
    ["http://evil.example", "null", "", "http://127.0.0.1", "http://127.0.0.1:8081", "http://localhost:8080"],
)
@pytest.mark.parametrize("access", [HOME, OPEN])
def test_pages_from_elsewhere_are_refused(origin: str, access: Access) -> None:
    assert access.refusal(Headers({"host": "127.0.0.1:8080", "origin": origin}), "http") is not None


@pytest.mark.parametrize(
    ("site", "mode", "destination", "is_answered"),
    [
        ("none", "navigate", "document", True),
        ("same-origin", "cors", "empty", True),
        ("cross-site", "navigate", "document", True),
        ("cross-site", "navigate", "iframe", False),
        ("cross-site", "no-cors", "image", False),
        ("cross-site", "no-cors", "script", False),
        ("same-site", "cors", "empty", False),
    ],
)
def test_others_may_link_here_and_no_more(site: str, mode: str, destination: str, is_answered: bool) -> None:
    headers = {"host": "127.0.0.1:8080", "sec-fetch-site": site, "sec-fetch-mode": mode, "sec-fetch-dest": destination}
    assert (HOME.refusal(Headers(headers), "http") is None) is is_answered


def test_only_the_cookie_of_this_process_admits() -> None:
    other = Access("0.0.0.0", 8080, OPEN.token)
    assert OPEN.admits(Headers({"cookie": f"a=b; {OPEN.cookie}={OPEN.pass_}; c=d"}))
    for cookie in ("", f"{OPEN.cookie}=", f"{OPEN.cookie}={OPEN.token}", f"{OPEN.cookie}={other.pass_}", "=;=é;;"):
        assert not OPEN.admits(Headers({"cookie": cookie}))
    assert HOME.admits(Headers({}))


@pytest.mark.parametrize("token", ["", "a-token-of-the-use", "a-token-of-the-userr", "é", "\udcff"])
def test_no_other_token_is_the_token(token: str) -> None:
    assert OPEN.is_token("a-token-of-the-user")
    assert not OPEN.is_token(token)
    assert not HOME.is_token(token)


def test_neither_token_nor_cookie_is_shown_with_the_rule() -> None:
    assert OPEN.pass_ not in repr(OPEN)
    assert "a-token" not in repr(OPEN)
