# SPDX-License-Identifier: BSD-3-Clause
"""Flattens a collection of pieces with ParaView, on as many processes as MPI starts.

    pvbatch flatten_collection.py --plugin SurfaceFlattening.so pieces.vtm flat.vtm
    mpiexec -n 8 pvbatch flatten_collection.py --plugin SurfaceFlattening.so pieces.vtm flat.vtm

Each block is a piece with its curves as line cells (Examples/Python/make_collection.py writes such
files). ParaView deals the blocks out to the processes. The pieces are taken a portion at a time, so that
memory does not grow with the collection; flat.csv has one row for each flat piece, with its status and measures.

What is done stays in the folder flat/. After a fault the same command continues with what is missing: the
portion in which a run died is taken again piece by piece, and a piece in which a run died alone gets the
status Died and is not taken again. Another collection or scheme wants another folder.

A catalogue of 2000 pieces with 2.6 million triangles took 62 s of processor time on one process, 31 ms a
piece: 27 ms to read, flatten and write it, which processes share, and 3 to 4 ms for the table and the start,
which they do not. By reckoning 100,000 such pieces take 52 minutes on one process, half an hour on two and
12 minutes on eight that have a processor each. Another of 360 garment pieces in 30 sizes, 434,000 triangles,
took 12.9 s on one process, 36 ms a piece. Two processes wrote the same table, digit for digit, and so did a run
that was killed after 120 pieces and started again.

With ParaView 5.13 on two processors that others used as well, on 2026-11-24, 2000 pieces with 2.5 million triangles
took one process 89 to 101 s of processor time, a third of it for files (308 and 97 s of clock), and two processes 176
to 191 s together (197 and 248 s of clock); the tables were the same, byte for byte. A process that waits for another
one keeps its processor busy: two that have a processor each take half of that sum at most, which means only that
they are not slower. The times for two and eight above remain reckoned.
"""

import argparse
import csv
import os
import sys
import time
from xml.etree import ElementTree

import paraview.simple as pv
from paraview import servermanager


def read_index(path):
    """Name and file of each piece of a collection."""
    folder = os.path.dirname(os.path.abspath(path))
    return [(element.get("name") or f"piece {number}", os.path.join(folder, element.get("file")))
            for number, element in enumerate(ElementTree.parse(path).getroot().iter("DataSet"))]


def write_index(path, pieces):
    """A collection of pieces, whose files may be None."""
    root = ElementTree.Element("VTKFile", type="vtkMultiBlockDataSet", version="1.0")
    blocks = ElementTree.SubElement(root, "vtkMultiBlockDataSet")
    folder = os.path.dirname(os.path.abspath(path))
    for number, (name, file) in enumerate(pieces):
        element = ElementTree.SubElement(blocks, "DataSet", index=str(number), name=name)
        if file:
            element.set("file", os.path.relpath(file, folder))
    ElementTree.ElementTree(root).write(path + ".part", encoding="utf-8", xml_declaration=True)
    os.replace(path + ".part", path)


def leaves_by_block(data, count):
    """The tables of each block: with several processes each gives a collection of its own, within or, from ParaView
    6.1 on, after that of the one before."""
    found = [[] for _ in range(count)]

    def visit(group):
        for block in range(group.GetNumberOfBlocks()):
            child = group.GetBlock(block)
            if child is not None and child.IsA("vtkMultiBlockDataSet"):
                visit(child)
            elif child is not None and child.GetNumberOfRows():
                found[block % count].append(child)

    visit(data)
    return found


def rows_of(tables, block, name):
    """One row for each flat piece, as dictionaries."""
    for table in tables:
        columns = [table.GetColumn(k) for k in range(table.GetNumberOfColumns())]
        for row in range(table.GetNumberOfRows()):
            yield {"Block": block, "Name": name,
                   **{column.GetName(): column.GetVariantValue(row).ToString() for column in columns
                      if column.GetName() != "Name"}}


class Collection:
    def __init__(self, options):
        self.pieces = read_index(options.collection)
        self.folder = os.path.splitext(options.flat)[0]
        os.makedirs(self.folder, exist_ok=True)
        self.reader = pv.XMLMultiBlockDataReader(FileName=[options.collection])
        self.flattening = pv.FlattenSurfaceWireWarping(Input=self.reader, Scheme=options.scheme, BesideSurface=0)

    def file(self, first, last, ending):
        return os.path.join(self.folder, f"{first:06}-{last:06}{ending}")

    def flatten(self, first, last):
        """The pieces from first to last that are not done."""
        if os.path.exists(self.file(first, last, ".csv")):
            return
        begun = self.file(first, last, ".begun")
        if not os.path.exists(begun):
            with open(begun, "w", encoding="utf-8"):
                pass
            self.run(first, last)
        elif last - first > 1:
            print(f"pieces {first} to {last - 1} one by one, since a run died among them", flush=True)
            for piece in range(first, last):
                self.flatten(piece, piece + 1)
            self.join(first, last)
        else:
            self.finish(first, last, [{"Block": first, "Name": self.pieces[first][0], "Status": "Died"}],
                        [(self.pieces[first][0], None)])
        os.remove(begun)

    def run(self, first, last):
        part = self.pieces[first:last]
        index = self.file(first, last, ".pieces.vtm")
        # ParaView waits for ever where a process has no piece: the last one is taken again there.
        processes = servermanager.ActiveConnection.GetNumberOfDataPartitions()
        taken = part + part[-1:] * (processes - len(part))
        write_index(index, taken)
        self.reader.FileName = [index]
        flat = self.file(first, last, ".flat.vtm")
        # Within the elements: Debian's ParaView 5.11 cannot read appended data.
        pv.SaveData(flat, proxy=self.flattening, DataMode="Binary")
        tables = leaves_by_block(servermanager.Fetch(self.flattening, idx=3), len(taken))
        rows = []
        for k, (name, _) in enumerate(part):
            rows += list(rows_of(tables[k], first + k, name)) or [
                {"Block": first + k, "Name": name, "Status": "NotRead"}]
        files = {}
        for element in ElementTree.parse(flat).getroot().iter("DataSet"):
            path = os.path.join(self.folder, element.get("file") or "")
            if os.path.isfile(path):
                files.setdefault(int(element.get("index")), []).append(path)
        # A process that has not the piece may write an empty one.
        flats = [(name, max(files.get(k, [None]), key=lambda file: os.path.getsize(file) if file else 0))
                 for k, (name, _) in enumerate(part)]
        self.finish(first, last, rows, flats)
        for path in (index, flat):
            os.remove(path)

    def join(self, first, last):
        singles = [(piece, piece + 1) for piece in range(first, last)]
        self.finish(first, last, self.rows(singles), self.flats(singles))

    def finish(self, first, last, rows, flats):
        """The table comes last: where it is, all is done."""
        write_index(self.file(first, last, ".vtm"), flats)
        write_table(self.file(first, last, ".csv"), rows)

    def rows(self, portions):
        rows = []
        for portion in portions:
            with open(self.file(*portion, ".csv"), encoding="utf-8", newline="") as file:
                rows += csv.DictReader(file)
        return rows

    def flats(self, portions):
        flats = []
        for portion in portions:
            path = self.file(*portion, ".vtm")
            for element in ElementTree.parse(path).getroot().iter("DataSet"):
                file = element.get("file")
                flats.append((element.get("name"), file and os.path.join(self.folder, file)))
        return flats


def write_table(path, rows):
    columns = list(dict.fromkeys(name for row in rows for name in row))
    with open(path + ".part", "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)
    os.replace(path + ".part", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("collection", help="a .vtm file")
    parser.add_argument("flat", help="the .vtm file to write; beside it a .csv file and a folder")
    parser.add_argument("--plugin", help="the plugin, where ParaView does not load it by itself")
    parser.add_argument("--scheme", default="Isometric", choices=("Progressive", "Global", "Isometric"))
    parser.add_argument("--portion", type=int, default=500, help="pieces that are taken at a time")
    options = parser.parse_args()
    if options.plugin:
        pv.LoadPlugin(options.plugin, remote=True)
    if not hasattr(pv, "FlattenSurfaceWireWarping"):
        parser.error("ParaView has not loaded the plugin SurfaceFlattening: start by build-paraview/bin/pvbatch or "
                     "`surfaceflattening-paraview pvbatch`, or name the plugin's file with --plugin")
    if not os.path.isfile(options.collection):
        parser.error(f"no file {options.collection}")
    collection = Collection(options)
    count = len(collection.pieces)
    portions = [(first, min(first + options.portion, count))
                for first in range(0, count, options.portion)]
    for portion in portions:
        start = time.time()
        collection.flatten(*portion)
        print(f"{portion[1]} of {count} pieces, {time.time() - start:.1f} s", flush=True)
    rows = collection.rows(portions)
    write_index(options.flat, collection.flats(portions))
    write_table(os.path.splitext(options.flat)[0] + ".csv", rows)
    statuses = [row["Status"] for row in rows]
    print(f"{options.flat}: {count} pieces, {len(rows)} flat ones: " +
          ", ".join(f"{statuses.count(status)} {status}" for status in sorted(set(statuses))))
    sys.stdout.flush()


main()
