# What the module is made of but its C interface, and what it links: for the module, and for the native program of tests/host/live/web.
set(SIGHTLINE_ROOMS flying.cpp kinds.cpp requests.cpp rooms.cpp stripes.cpp studio.cpp turning.cpp workbench.cpp)
set(SIGHTLINE_ROOMS_LIBRARIES sightline_live sightline_host_machines sightline_explain sightline_oracle sightline_hidden_lines sightline_registry
  sightline_programs_flight sightline_programs_jones sightline_programs_skala sightline_programs_stripes sightline_programs_turn sightline_machines sightline_asm
  sightline_disasm sightline_image sightline_picture sightline_scene sightline_base fmt::fmt)
