# SPDX-License-Identifier: BSD-3-Clause
"""Flattens a collection of pieces with ParaView, on as many processes as MPI starts.

    pvbatch flatten_collection.py --plugin SurfaceFlattening.so pieces.vtm flat.vtm
    mpiexec -n 8 pvbatch flatten_collection.py --plugin SurfaceFlattening.so pieces.vtm flat.vtm

Each block is a piece with its curves as line cells (Examples/Python/make_collection.py writes such
files). ParaView deals the blocks out to the processes.
"""

import argparse
import sys

import paraview.simple as pv

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("collection", help="a .vtm file")
parser.add_argument("flat", help="the .vtm file to write")
parser.add_argument("--plugin", help="the plugin, where ParaView does not load it by itself")
parser.add_argument("--scheme", default="Isometric",
                    choices=("Progressive", "Global", "Isometric", "Least squares conformal"))
options = parser.parse_args()

if options.plugin:
    pv.LoadPlugin(options.plugin, remote=True)
pieces = pv.XMLMultiBlockDataReader(FileName=[options.collection])
flattening = pv.WireWarping(Input=pieces, Scheme=options.scheme)
flattening.UpdatePipeline()
pv.SaveData(options.flat, proxy=flattening, DataMode="Binary")
information = flattening.GetDataInformation()
print(f"{options.flat}: {information.GetNumberOfCells()} triangles")
sys.stdout.flush()
