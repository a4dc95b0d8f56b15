# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of a batch."""


def checked(line):
    """A result with the check that it would have, had a batch written it: FNV-1a, 64 bits, of all before."""
    members = line[:line.index(',"check":')]
    check = 14695981039346656037
    for byte in members.encode():
        check = (check ^ byte) * 1099511628211 % 2 ** 64
    return f'{members},"check":"{check:016x}"}}'
