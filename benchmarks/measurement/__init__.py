"""How fast the engine answers, beside every other way: sides, interleaved timing, tables and a picture."""
