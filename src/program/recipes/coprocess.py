# Tangled from paper/L-recipes.md; edit there.
import subprocess

command = ["thermoroll", "sweep", "--peclet", "100", "--heating", "1", "--columns", "creep,max_temperature"]
solver = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

def ask(row):
    print(row, file=solver.stdin, flush=True)
    return solver.stdout.readline().rstrip("\n")

print(ask("friction,traction"))
for traction in (0.1, 0.2, 0.3, 0.4):
    print(ask(f"0.6,{traction}"))
