"""How many windows one studio serves."""

from __future__ import annotations

from nicegui import Client

MOST_SESSIONS = 32
FULL = (
    f"This studio serves {MOST_SESSIONS} windows, and all are open. Close one, or start another studio on another port."
)


def made_room(newcomer: Client) -> bool:
    """Whether a further window has a place: if all are taken, the one left first is given up, but none in use."""
    others = [client for client in Client.instances.values() if client is not newcomer]
    if len(others) < MOST_SESSIONS:
        return True
    left = [client for client in others if not client.has_socket_connection]
    if not left:
        return False
    give_up(min(left, key=lambda client: client.created))
    return True


def give_up(client: Client) -> None:
    """End a window's session."""
    # NiceGUI would delete it once more when its time to reconnect is over, and find nothing.
    for task in client._delete_tasks.values():
        task.cancel()
    client.delete()
