"""Results of a run: numbers, tables, files for ParaView and pictures. No DOLFINx."""

from braidx.output.contact_table import ContactTable
from braidx.output.core_line import CoreLine
from braidx.output.sheave_picture import SheavePicture
from braidx.output.skin_picture import SkinPicture
from braidx.output.snapshot import Snapshot

__all__ = ["ContactTable", "CoreLine", "SheavePicture", "SkinPicture", "Snapshot"]
