# SPDX-License-Identifier: BSD-3-Clause
"""Folders that several scripts write into."""
import pathlib
import sys


def make_folder(script, folder):
    """Makes it, and those above; ends the script with a reason where that cannot be."""
    try:
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        sys.exit(f"{script}: folder '{folder}': got '{error.strerror}', expected one that can be written into")
