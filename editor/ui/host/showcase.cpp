#include "editor/ui/host/scripted_ui.h"

namespace editor {

const char* const kShowcase = R"(
new
create 70,1,60 0,0,0 index=6 name=floor static=yes
entry 6 color=#7d7a74 roughness=0.8 shape=floor
create 50,26,3 0,0.1,2 index=7 name=wall static=yes
entry 7 color=#a8543c roughness=0.9 shape=wall
entry 5 color=#8a5a30 roughness=0.6 shape=wall
entry 4 color=#d8d2c4 roughness=0.8 material=brick shape=wall
box 18,0,0 25,20,2 erase shape=wall
box 36,8,0 43,17,2 erase shape=wall
create 8,20,1 -0.3,0.1,2 index=5 name=door
entry 5 color=#6e4522 roughness=0.5 shape=door
joint hinge door wall -0.7,1,2 0,1,0 low=-100 high=100 search=0.6 name=door_hinge
create 8,8,8 1.4,0.1,-0.6 name=crate
entry 5 color=#b98542 roughness=0.7 shape=crate
duplicate 0.3,0.8,0.1 2 crate
create 14,14,14 -2,0.1,-0.4 form=sphere index=9 name=ball
entry 9 color=#9aa4b0 roughness=0.25 metallic=1 shape=ball
create 4,24,4 2.9,0.1,0.6 index=9 name=post static=yes
light cone 2.6,2.6,0.4 -90,0,0 color=60,44,24 cone=60 reach=8 name=spot
time 10
ui camera -2.6,3.2,-6.2 0.2,0.9,0.8
select ball
ui tab Palette
ui brush sphere add size=3 index=9
ui hover -2,1.3,-0.9
ui screenshot 01_brushes.png
ui click
ui tab Properties
select ball
ui mode move
ui hover -1.7,0.85,-0.35
ui press
ui by -45 15
ui by -45 15
ui screenshot 02_gizmo.png
ui release
undo 2
select wall
ui brush face paint index=4 size=1
ui tab Palette
ui hover -1.6,1.2,1.85
ui screenshot 03_palette.png
ui click
ui mode select
select door
ui leave
ui tab Properties
ui screenshot 04_tree.png
select wall
box 30,22,0 31,25,2 erase
box 30,22,0 49,22,2 erase
ui tab View
ui overlay components
ui overlay anchors
ui screenshot 05_components.png
ui overlay components no
ui overlay anchors no
undo 2
layer house wall
hide tag:layer=house
ui tab Properties
ui screenshot 14_hidden.png
show
undo
select door_hinge
ui mode rotate
ui screenshot 15_joint.png
ui mode select
create 40,3,6 -1.6,1.6,-2.6 index=5 name=beam static=yes
entry 5 color=#9a6a3a roughness=0.7 shape=beam
box 0,-16,0 5,-1,5 index=5 shape=beam
anchor beam
shape beam strength=12
select beam
ui overlay load
ui screenshot 13_load.png
ui overlay load no
undo 5
select wall
ui mode break
ui breaker explode 0.9
ui tab Profiler
ui overlay contacts
play
explode 0.3,1.2,1.8 1.1
ui play 45
ui screenshot 06_profiler.png
ui overlay contacts no
stop
ui mode select
ui tab Replay
ui replay 16
ui screenshot 07_replay.png
ui live
ui leave
time 21.5
exposure 1.6
select spot
ui mode select
ui overlay lights
ui tab Sky
ui screenshot 08_night.png
ui overlay lights no
undo 2
ui tab History
ui tab Properties
ui brush line erase size=2
select wall
ui hover 1.2,2.1,1.85
ui press
ui by 90 6
ui screenshot 09_history.png
ui release
ui leave
ui commands light
ui screenshot 10_commands.png
save $OUT/model.rubble
ui form import file=$OUT/model.rubble at=0,0,8 turn=0,90,0
ui screenshot 11_import.png
ui close
import $OUT/model.rubble 0,0,8 0,90,0
ui tab Messages
ui camera -5,6,-7 0.5,0.5,4
ui screenshot 12_imported.png
)";

const char* const kLevelShowcase = R"(
ui screenshot 01_level.png
ui overlay anchors
ui overlay joints
ui overlay lights
ui overlay groups
ui tab View
ui screenshot 02_overlays.png
ui overlay anchors no
ui overlay joints no
ui overlay lights no
ui overlay groups no
ui tab Palette
ui brush sphere add size=4
ui at 600 300
ui screenshot 03_brush.png
ui leave
ui mode select
ui tab Sky
ui tab Messages
ui screenshot 04_sky.png
ui tab Properties
ui overlay contacts
play
ui play 60
ui tab Profiler
ui screenshot 05_play.png
ui overlay contacts no
stop
ui tab Replay
ui replay 30
ui screenshot 06_replay.png
ui live
ui tab History
ui commands light
ui screenshot 07_commands.png
ui close
)";

}  // namespace editor
