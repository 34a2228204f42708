"""The place where the studio can be reached."""

from __future__ import annotations

import errno
import socket

from strainwave.errors import StrainwaveError

LOOPBACK = "127.0.0.1"
FIRST_PORT = 8080
PORTS_TRIED = 20


def listening_socket(host: str, port: int | None) -> socket.socket:
    """A socket bound to an address of this machine: to `port` (0 is any free one), or the first free from 8080 on.

    Raises ``StrainwaveError`` with what to do where the port is taken or the address is not this machine's.
    """
    ports = range(FIRST_PORT, FIRST_PORT + PORTS_TRIED) if port is None else (port,)
    for each in ports:
        try:
            return _bound(host, each)
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise StrainwaveError(f"{host}:{each}: cannot listen there: {error.strerror or error}") from None
    taken = f"port {port} is" if port is not None else f"the ports from {ports[0]} to {ports[-1]} are"
    raise StrainwaveError(f"{taken} taken by another program; name another with --port, or --port 0 for any free one")


def _bound(host: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    bound = socket.socket(family, socket.SOCK_STREAM)
    try:
        # Without it a port would stay taken for a minute after the studio that had it has ended.
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        bound.bind((host, port))
        # Listening at once: two that bind the same port with SO_REUSEADDR differ only here.
        bound.listen(128)
    except OSError:
        bound.close()
        raise
    return bound
