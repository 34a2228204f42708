"""Further users of the same studio: windows without a browser that keep changing w0. Run as a process of its own."""

from __future__ import annotations

import asyncio
import json
import random
import sys
import time

from tests.studio.socket_client import SocketClient

W0 = "wave_generator.w0"
PAUSE_S = 0.25
# Half of it is deep interference, where an analysis takes up to 25 ms.
RANGE_MM = 0.80, 0.88


async def changes_ms(client: SocketClient, seconds: float, chance: random.Random) -> list[float]:
    """How long each change took, from the event that is sent to the drawing's data that comes back."""
    key = next(key for key, node in client.found(lambda node: node.get("props", {}).get("field") == W0))
    until, waits = time.monotonic() + seconds, []
    while time.monotonic() < until:
        began, before = time.perf_counter(), client.messages[-1:]
        await client.send(key, "edit", {"number": round(chance.uniform(*RANGE_MM), 6)})
        while client.messages[-1:] == before or "show" not in str(client.messages[-1])[:80]:
            client.heard.clear()
            await client.heard.wait()
        waits.append(1000.0 * (time.perf_counter() - began))
        await asyncio.sleep(chance.uniform(0.5, 1.5) * PAUSE_S)
    return waits


async def main() -> None:
    """Arguments: address, number of windows, seconds. Prints a line when all are there, and then the times as JSON."""
    address, count, seconds = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
    clients = [await SocketClient.opened(address) for _ in range(count)]
    print("ready", flush=True)
    waits = await asyncio.gather(*(changes_ms(each, seconds, random.Random(n)) for n, each in enumerate(clients)))
    print(json.dumps([wait for each in waits for wait in each]), flush=True)
    for client in clients:
        await client.disconnect()


if __name__ == "__main__":
    asyncio.run(main())
