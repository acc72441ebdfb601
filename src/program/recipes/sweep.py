# Tangled from paper/L-recipes.md; edit there.
import numpy
import thermoroll

scenes = numpy.genfromtxt("scenes.csv", delimiter=",", names=True)
found = thermoroll.solve(**{name: scenes[name] for name in scenes.dtype.names}, tolerance=1e-3)

k = numpy.nanargmax(found.max_temperature)
print(f"{len(scenes)} scenes, {numpy.count_nonzero(found.status)} failed")
print(f"row {k + 1} is the hottest: T* = {found.max_temperature[k]:.4g} +- {found.errors.max_temperature[k]:.0e}")
