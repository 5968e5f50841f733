# Run by Blender: imports BVH files with its own add-on and writes where the bones are.
# Arguments behind "--": a JSON list of {"file", "positions"}; positions get {"bones": [...], "frames": [[x, y, z, ...]]},
# six numbers for each bone and frame: head and tail, in the axes and units of the file.
import json
import sys
from pathlib import Path

import addon_utils
import bpy
from mathutils import Matrix


def load_importer():
    """The add-on's importer without the mode of open() that Python 3.11 no longer has."""
    addon = next(module for module in addon_utils.modules() if module.__name__ == "io_anim_bvh")
    source = Path(addon.__file__).with_name("import_bvh.py")
    importer = {"__name__": "import_bvh"}
    text = source.read_text(encoding="utf8").replace("open(file_path, 'rU')", "open(file_path, 'r')")
    exec(compile(text, str(source), "exec"), importer)
    return importer["load"]


def read_positions(load, file):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    load(bpy.context, file, target="ARMATURE", rotate_mode="NATIVE", global_matrix=Matrix(), report=lambda *words: None)
    armature = bpy.context.view_layer.objects.active
    first, last = (round(end) for end in armature.animation_data.action.frame_range)
    frames = []
    for frame in range(first, last + 1):
        bpy.context.scene.frame_set(frame)
        points = (armature.matrix_world @ point for bone in armature.pose.bones for point in (bone.head, bone.tail))
        frames.append([coordinate for point in points for coordinate in point])
    return {"bones": [bone.name for bone in armature.pose.bones], "frames": frames}


load_bvh = load_importer()
for job in json.loads(Path(sys.argv[sys.argv.index("--") + 1]).read_text(encoding="utf8")):
    try:
        answer = read_positions(load_bvh, job["file"])
    except Exception as failure:
        answer = {"complaint": f"{type(failure).__name__}: {failure}"}
    Path(job["positions"]).write_text(json.dumps(answer), encoding="utf8")
