# What the module is made of but its C interface, and what it links: for the module, and for the native program of tests/host/live/web.
set(SIGHTLINE_ROOMS flying.cpp kinds.cpp requests.cpp rooms.cpp stripes.cpp studio.cpp turning.cpp workbench.cpp)
set(SIGHTLINE_ROOMS_LIBRARIES sightline_live sightline_run sightline_explain sightline_oracle sightline_registry
  sightline_guest_flight sightline_guest_jones sightline_guest_skala sightline_guest_stripes sightline_guest_turn sightline_machines sightline_asm
  sightline_disasm sightline_image sightline_picture sightline_scene sightline_base fmt::fmt)
