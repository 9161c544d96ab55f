"""Prints the milliseconds (best of 3) and the number of components of scipy.ndimage.label: labels_scipy.py FILE Z Y X"""
import sys
import time

import numpy
from scipy import ndimage

cells = numpy.fromfile(sys.argv[1], dtype=numpy.uint8).reshape([int(size) for size in sys.argv[2:5]])
best = 1e30
for _ in range(3):
    start = time.perf_counter()
    labels, count = ndimage.label(cells)
    best = min(best, time.perf_counter() - start)
print(best * 1e3, count)
