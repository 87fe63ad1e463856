#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Verify somebody else's certificate.

    python3 verify_certificate.py CERTIFICATE [MESH [PICTURE]]

The checker shares no code with the algorithms. With the mesh it also makes sure that the claim is
about this mesh. A changed byte is found out, also where the seal is made anew.
"""

import sys

import crest


def main(certificate, mesh=None, picture=None):
    with open(certificate, "rb") as file:
        data = file.read()
    given = None if mesh is None else crest.read_mesh(mesh)
    verdict = crest.verify(data, mesh=given)
    for claim in verdict.claims:
        print(" -", claim)
    print("accepted" if verdict else "REJECTED: " + verdict.reason)
    broken = bytearray(data)
    broken[len(broken) // 2] ^= 1
    print("with one bit changed:", crest.verify(broken).reason or "accepted")
    if picture is not None and given is not None:
        crest.lineart(*given, style="contours", view=(30, 20), width=80).save(picture)
    return 0 if verdict else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
