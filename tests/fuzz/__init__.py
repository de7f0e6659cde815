"""Attacks on every door: files, calls, command lines and results read back.

Each input is drawn from a seed of its own. It must be answered, or be refused in words, within ten
seconds; what is answered is compared with a computation that shares no code with the package.

    make fuzz                                  a large dose of everything
    make fuzz DOSE=1000 FUZZ="--only calls"    a smaller one of one surface
    make fuzz FUZZ="--input calls:1:4711"      one input again: surface, seed, number
"""
