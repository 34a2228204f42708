"""What passes the gate, and with which words the rest is turned away."""

from __future__ import annotations

import pytest

from strainwave.studio.guard import Access
from tests.studio.guard.asking import HOME, OPEN, asked, knocked

TOKEN = "a-token-of-the-user"
COOKIE = f"{OPEN.cookie}={OPEN.pass_}"


def test_the_own_page_is_answered() -> None:
    assert asked(HOME, "/").status_code == 200
    assert asked(HOME, "/static.js", headers={"origin": "http://127.0.0.1:8080"}).status_code == 200
    assert knocked(HOME, origin="http://127.0.0.1:8080") == "websocket.accept"


@pytest.mark.parametrize("path", ["/", "/static.js", "/_nicegui/x/static/vue.js"])
@pytest.mark.parametrize("headers", [{"host": "evil.example"}, {"origin": "http://evil.example"}])
def test_others_are_not(path: str, headers: dict[str, str]) -> None:
    answer = asked(HOME, path, headers=headers)
    assert answer.status_code == 403
    assert answer.headers["content-type"].startswith("text/plain")
    assert knocked(HOME, **headers) == "websocket.close"


def test_the_socket_speaks_no_http() -> None:
    assert asked(HOME, "/_nicegui_ws/socket.io/?transport=polling", "POST", content=b"x").status_code == 400


@pytest.mark.parametrize(
    "path", ["/", "/static.js", "/favicon.ico", "/framed", f"/static.js?token={TOKEN}", "/?token="]
)
def test_without_the_token_nothing_is_answered(path: str) -> None:
    answer = asked(OPEN, path)
    assert answer.status_code == 401
    assert answer.text.startswith("This studio asks for a token.")
    assert "set-cookie" not in answer.headers


def test_without_the_token_no_socket_is_opened() -> None:
    origin = "http://192.0.2.1:8080"
    assert knocked(OPEN, origin=origin) == "websocket.close"
    assert knocked(OPEN, origin=origin, cookie=f"{OPEN.cookie}={TOKEN}") == "websocket.close"
    assert knocked(OPEN, origin=origin, cookie=COOKIE) == "websocket.accept"
    assert knocked(OPEN, origin="http://evil.example", cookie=COOKIE) == "websocket.close"


@pytest.mark.parametrize(
    ("query", "rest"),
    [
        (f"token={TOKEN}", "/"),
        (f"design=eJx%2B&token={TOKEN}&x=1", "/?design=eJx%2B&x=1"),
        (f"token=wrong&token={TOKEN}", "/"),
    ],
)
def test_the_token_leaves_the_address_for_a_cookie(query: str, rest: str) -> None:
    answer = asked(OPEN, f"/?{query}")
    assert (answer.status_code, answer.headers["location"]) == (303, rest)
    cookie = answer.headers["set-cookie"]
    assert TOKEN not in cookie
    assert cookie.startswith(f"{COOKIE}; HttpOnly; Path=/; SameSite=lax")
    assert asked(OPEN, rest, headers={"cookie": COOKIE}).status_code == 200


CROSS = {"sec-fetch-site": "cross-site"}
VISIT = {**CROSS, "sec-fetch-mode": "navigate", "sec-fetch-dest": "document"}


def test_the_cookie_comes_with_a_link_from_elsewhere_and_opens_the_page() -> None:
    assert asked(OPEN, "/", headers={"cookie": COOKIE, **VISIT}).status_code == 200
    assert asked(OPEN, "/?design=eJx", headers={"cookie": COOKIE, **VISIT}).status_code == 200


@pytest.mark.parametrize(
    ("method", "headers"),
    [
        ("GET", {**CROSS, "sec-fetch-mode": "no-cors", "sec-fetch-dest": "image"}),
        ("GET", {**CROSS, "sec-fetch-mode": "navigate", "sec-fetch-dest": "iframe"}),
        ("GET", {**CROSS, "sec-fetch-mode": "navigate", "sec-fetch-dest": "embed"}),
        ("GET", {"sec-fetch-site": "same-site", "sec-fetch-mode": "cors", "sec-fetch-dest": "empty"}),
        # A form of another site's page: browsers say whose it is, or "null".
        ("POST", {**VISIT, "origin": "http://evil.example"}),
        ("POST", {**VISIT, "origin": "null"}),
        ("POST", VISIT),
    ],
)
@pytest.mark.parametrize("path", ["/", "/static.js", "/_nicegui/client/x/upload/1"])
def test_with_the_cookie_other_sites_may_still_only_link_here(method: str, headers: dict[str, str], path: str) -> None:
    answer = asked(OPEN, path, method, headers={"cookie": COOKIE, **headers})
    assert (answer.status_code, answer.text) == (403, "Another site's page may not use this studio.")


@pytest.mark.parametrize("path", ["//evil.example/", "//evil.example", "/x"])
def test_the_token_leads_nowhere_else(path: str) -> None:
    assert asked(OPEN, f"http://192.0.2.1:8080{path}?token={TOKEN}").status_code == 401


def test_on_loopback_a_token_is_asked_for_where_one_is_given() -> None:
    access = Access("127.0.0.1", 8080, TOKEN)
    assert asked(access, "/").status_code == 401
    assert asked(access, f"/?token={TOKEN}").status_code == 303


def test_an_endless_address_is_refused() -> None:
    assert asked(HOME, f"/?design={'x' * 39_000}").status_code == 200
    assert asked(HOME, f"/?design={'x' * 41_000}").status_code == 414
    assert asked(HOME, f"/{'x' * 41_000}").status_code == 414


def test_no_proxy_is_believed() -> None:
    assert asked(HOME, "/said", headers={"x-forwarded-prefix": "/evil"}).text == "None 0"
