"""A fabric in Python: make a case, check it, run it, look at its contacts, sweep the friction.

The cells, from one "# %%" to the next, run one by one in an editor that knows them, or all with

    PYTHONPATH=build/release/python python3 examples/11-python/wale_tension.py
"""

# %% Make a case: the words and the texts with units are those of the case file.
import importlib.util
import pathlib

import numpy as np

import knitmech

results = pathlib.Path("results/11-python")
case = knitmech.Case.new()
case["title"] = "Jersey of 5 wales and 8 courses"
case["fabric.wales"] = 5
case["fabric.courses"] = 8
case["test.strain"] = 0.16
case["output.frames_at"] = [0.04, 0.08, 0.12]
case["output.history_points"] = 400

# %% Check it: nothing is simulated yet.
check = case.check()
print(f"{check['loop_length_mm']:.3f} mm of yarn in a stitch")
print(f"{check['mass_per_area_g_per_m2']:.1f} g/m^2, {check['estimated_seconds']:.0f} s to run")
print(f"{check['elements']} elements, EI {check['bending_stiffness_N_mm2']:.4g} N mm^2")

# %% A wrong value is refused where it is set; the sentence says what would be right.
try:
    case["loop.height"] = "7 N"
except knitmech.CaseError as error:
    print(error)

# %% The model: nodes, elements and node sets are NumPy arrays, in mm.
model = case.model()
size = np.ptp(model.nodes, axis=0)
print(f"{len(model.nodes)} nodes in {size[0]:.1f} x {size[1]:.1f} x {size[2]:.2f} mm")
print(f"{len(model.node_sets['top_heads'])} nodes are pulled")


# %% Run it, and look at each frame as it comes.
def look(frame: knitmech.Frame) -> None:
    contacts = frame.contacts
    force = contacts["normal_force_N"] * 1e3
    print(
        f"at {frame.strain:5.1%} strain: {len(contacts):3} contacts with {force.sum():6.3f} mN, "
        f"the largest with {force.max(initial=0):.3f} mN"
    )


run = case.run(results / "jersey", on_frame=look)
quality = run.summary["quality"]
print(f"{run.status}: {quality['verdict']}")

# %% The curve: columns of the history by their names, with their units in these.
strain, force = run.history["strain"], run.history["force_top_N"]
print(f"{np.interp(0.15, strain, force) * 1e3:.3f} mN at 15 % strain")

# %% A frame: where is the yarn bent most? Rows of elements and frame fields are the same.
frame = run.frame()
bent = np.argmax(frame.bending_moment)
node = run.model.elements[bent, 0]
print(
    f"bent most with {frame.bending_moment[bent]:.2g} N mm at {frame.positions[node].round(2)} mm, "
    f"in course {run.model.course[node] + 1}"
)

# %% Sweep a parameter: a copy of the case for each value; friction 0.1 has been run already.
runs = {0.1: run}
for friction in (0.0, 0.3):
    varied = case.copy()
    varied["contact.friction"] = friction
    runs[friction] = varied.run(results / f"friction-{friction}")

print("friction  force at 15 %  lost to friction")
for friction, each in sorted(runs.items()):
    history = each.history
    pull = np.interp(0.15, history["strain"], history["force_top_N"])
    share = history["friction_loss_mJ"][-1] / history["external_work_mJ"][-1]
    print(f"{friction:8} {pull * 1e3:11.3f} mN {share:15.0%}")

# %% The curves as a table for any other program, and drawn where Matplotlib is installed.
strains = np.linspace(0, 0.16, 81)
curves = {
    friction: np.interp(strains, each.history["strain"], each.history["force_top_N"])
    for friction, each in sorted(runs.items())
}
table = np.column_stack([strains, *curves.values()])
header = ",".join(["strain", *(f"force_at_friction_{friction}_N" for friction in curves)])
np.savetxt(results / "curves.csv", table, "%.6g", ",", header=header, comments="")
print(f"Curves: {results / 'curves.csv'}")

if importlib.util.find_spec("matplotlib"):
    from matplotlib.figure import Figure

    axes = (figure := Figure()).subplots()
    for friction, curve in curves.items():
        axes.plot(strains * 100, curve * 1e3, label=f"friction {friction}")
    axes.set(xlabel="strain [%]", ylabel="force [mN]")
    axes.legend()
    figure.savefig(results / "curves.png")
