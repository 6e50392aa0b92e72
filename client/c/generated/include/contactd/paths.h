/* Written by ./dev generate from proto/schema: edit it there. */
/* Paths of fields and keywords for contactd.h. An entry of a list has its number printed in place of %d:
 *
 *     snprintf(path, sizeof path, CONTACTD_PATH_PATCHES_SOLUTION_PMAX, patch);
 */
#ifndef CONTACTD_PATHS_H
#define CONTACTD_PATHS_H

/* --- inputs of a contact --- */
#define CONTACTD_PATH_GRID "grid"
#define CONTACTD_PATH_GRID_NX "grid.nx"
#define CONTACTD_PATH_GRID_NY "grid.ny"
#define CONTACTD_PATH_GRID_DX "grid.dx" /* mm */
#define CONTACTD_PATH_GRID_DY "grid.dy" /* mm */
#define CONTACTD_PATH_GRID_X0 "grid.x0" /* mm */
#define CONTACTD_PATH_GRID_Y0 "grid.y0" /* mm */
#define CONTACTD_PATH_BODIES "bodies"
#define CONTACTD_PATH_BODIES_UPPER "bodies.upper"
#define CONTACTD_PATH_BODIES_UPPER_G "bodies.upper.G" /* N/mm^2 */
#define CONTACTD_PATH_BODIES_UPPER_NU "bodies.upper.nu"
#define CONTACTD_PATH_BODIES_UPPER_ICS "bodies.upper.ics"
#define CONTACTD_PATH_BODIES_UPPER_VISCOELASTIC "bodies.upper.viscoelastic"
#define CONTACTD_PATH_BODIES_UPPER_VISCOELASTIC_F "bodies.upper.viscoelastic.f"
#define CONTACTD_PATH_BODIES_UPPER_VISCOELASTIC_TAU "bodies.upper.viscoelastic.tau" /* s */
#define CONTACTD_PATH_BODIES_UPPER_RIGID "bodies.upper.rigid"
#define CONTACTD_PATH_BODIES_LOWER "bodies.lower"
#define CONTACTD_PATH_BODIES_LOWER_G "bodies.lower.G" /* N/mm^2 */
#define CONTACTD_PATH_BODIES_LOWER_NU "bodies.lower.nu"
#define CONTACTD_PATH_BODIES_LOWER_ICS "bodies.lower.ics"
#define CONTACTD_PATH_BODIES_LOWER_VISCOELASTIC "bodies.lower.viscoelastic"
#define CONTACTD_PATH_BODIES_LOWER_VISCOELASTIC_F "bodies.lower.viscoelastic.f"
#define CONTACTD_PATH_BODIES_LOWER_VISCOELASTIC_TAU "bodies.lower.viscoelastic.tau" /* s */
#define CONTACTD_PATH_BODIES_LOWER_RIGID "bodies.lower.rigid"
#define CONTACTD_PATH_ICS "ics"
#define CONTACTD_PATH_ICS_SOURCE "ics.source"
#define CONTACTD_PATH_ICS_BODY "ics.body"
#define CONTACTD_PATH_ICS_LOAD_SHAPE "ics.load_shape"
#define CONTACTD_PATH_ICS_SECTION "ics.section"
#define CONTACTD_PATH_ICS_SECTION_RAIL_60E1 "ics.section.rail_60e1"
#define CONTACTD_PATH_ICS_SECTION_RAIL_60E1_INCLINATION "ics.section.rail_60e1.inclination"
#define CONTACTD_PATH_ICS_SECTION_RAIL_60E1_SUPPORT "ics.section.rail_60e1.support"
#define CONTACTD_PATH_ICS_SECTION_RAIL_60E1_FROM "ics.section.rail_60e1.from" /* mm */
#define CONTACTD_PATH_ICS_SECTION_RIM_S1002 "ics.section.rim_s1002"
#define CONTACTD_PATH_ICS_SECTION_RIM_S1002_THICKNESS "ics.section.rim_s1002.thickness" /* mm */
#define CONTACTD_PATH_ICS_SECTION_RIM_S1002_FROM "ics.section.rim_s1002.from"           /* mm */
#define CONTACTD_PATH_ICS_SECTION_EDGE_BLOCK "ics.section.edge_block"
#define CONTACTD_PATH_ICS_SECTION_EDGE_BLOCK_WIDTH "ics.section.edge_block.width"                 /* mm */
#define CONTACTD_PATH_ICS_SECTION_EDGE_BLOCK_HEIGHT "ics.section.edge_block.height"               /* mm */
#define CONTACTD_PATH_ICS_SECTION_EDGE_BLOCK_EDGE_DISTANCE "ics.section.edge_block.edge_distance" /* mm */
#define CONTACTD_PATH_ICS_SECTION_GROOVE "ics.section.groove"
#define CONTACTD_PATH_ICS_SECTION_GROOVE_RADIUS "ics.section.groove.radius" /* mm */
#define CONTACTD_PATH_ICS_SECTION_GROOVE_DEPTH "ics.section.groove.depth"   /* mm */
#define CONTACTD_PATH_ICS_SECTION_GROOVE_WIDTH "ics.section.groove.width"   /* mm */
#define CONTACTD_PATH_ICS_SECTION_GROOVE_HEIGHT "ics.section.groove.height" /* mm */
#define CONTACTD_PATH_ICS_SECTION_ROUND_END "ics.section.round_end"
#define CONTACTD_PATH_ICS_SECTION_ROUND_END_RADIUS "ics.section.round_end.radius" /* mm */
#define CONTACTD_PATH_ICS_SECTION_ROUND_END_LENGTH "ics.section.round_end.length" /* mm */
#define CONTACTD_PATH_ICS_SECTION_DISC "ics.section.disc"
#define CONTACTD_PATH_ICS_SECTION_DISC_RADIUS "ics.section.disc.radius" /* mm */
#define CONTACTD_PATH_ICS_SECTION_DISC_CORE "ics.section.disc.core"     /* mm */
#define CONTACTD_PATH_ICS_SECTION_PLATE_HOLE "ics.section.plate_hole"
#define CONTACTD_PATH_ICS_SECTION_PLATE_HOLE_RADIUS "ics.section.plate_hole.radius"             /* mm */
#define CONTACTD_PATH_ICS_SECTION_PLATE_HOLE_PLATE_RADIUS "ics.section.plate_hole.plate_radius" /* mm */
#define CONTACTD_PATH_ICS_SECTION_SLAB "ics.section.slab"
#define CONTACTD_PATH_ICS_SECTION_SLAB_THICKNESS "ics.section.slab.thickness" /* mm */
#define CONTACTD_PATH_ICS_SECTION_SLAB_WIDTH "ics.section.slab.width"         /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE "ics.section.outline"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE "ics.section.outline.outside"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_START "ics.section.outline.outside.start"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_START_Y "ics.section.outline.outside.start.y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_START_Z "ics.section.outline.outside.start.z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS "ics.section.outline.outside.parts"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_LINE "ics.section.outline.outside.parts[%d].line"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_LINE_TO "ics.section.outline.outside.parts[%d].line.to"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_LINE_TO_Y \
    "ics.section.outline.outside.parts[%d].line.to.y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_LINE_TO_Z \
    "ics.section.outline.outside.parts[%d].line.to.z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_ARC "ics.section.outline.outside.parts[%d].arc"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_ARC_TO "ics.section.outline.outside.parts[%d].arc.to"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_ARC_TO_Y \
    "ics.section.outline.outside.parts[%d].arc.to.y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_ARC_TO_Z \
    "ics.section.outline.outside.parts[%d].arc.to.z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_ARC_RADIUS \
    "ics.section.outline.outside.parts[%d].arc.radius" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_SPLINE "ics.section.outline.outside.parts[%d].spline"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_SPLINE_THROUGH \
    "ics.section.outline.outside.parts[%d].spline.through"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_SPLINE_THROUGH_Y \
    "ics.section.outline.outside.parts[%d].spline.through[%d].y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_SPLINE_THROUGH_Z \
    "ics.section.outline.outside.parts[%d].spline.through[%d].z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_OUTSIDE_PARTS_CLAMPED "ics.section.outline.outside.parts[%d].clamped"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES "ics.section.outline.holes"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_START "ics.section.outline.holes[%d].start"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_START_Y "ics.section.outline.holes[%d].start.y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_START_Z "ics.section.outline.holes[%d].start.z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS "ics.section.outline.holes[%d].parts"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_LINE "ics.section.outline.holes[%d].parts[%d].line"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_LINE_TO "ics.section.outline.holes[%d].parts[%d].line.to"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_LINE_TO_Y \
    "ics.section.outline.holes[%d].parts[%d].line.to.y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_LINE_TO_Z \
    "ics.section.outline.holes[%d].parts[%d].line.to.z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_ARC "ics.section.outline.holes[%d].parts[%d].arc"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_ARC_TO "ics.section.outline.holes[%d].parts[%d].arc.to"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_ARC_TO_Y \
    "ics.section.outline.holes[%d].parts[%d].arc.to.y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_ARC_TO_Z \
    "ics.section.outline.holes[%d].parts[%d].arc.to.z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_ARC_RADIUS \
    "ics.section.outline.holes[%d].parts[%d].arc.radius" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_SPLINE "ics.section.outline.holes[%d].parts[%d].spline"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_SPLINE_THROUGH \
    "ics.section.outline.holes[%d].parts[%d].spline.through"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_SPLINE_THROUGH_Y \
    "ics.section.outline.holes[%d].parts[%d].spline.through[%d].y" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_SPLINE_THROUGH_Z \
    "ics.section.outline.holes[%d].parts[%d].spline.through[%d].z" /* mm */
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_HOLES_PARTS_CLAMPED "ics.section.outline.holes[%d].parts[%d].clamped"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_CARRIER "ics.section.outline.carrier"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_PART "ics.section.outline.part"
#define CONTACTD_PATH_ICS_SECTION_OUTLINE_FROM "ics.section.outline.from" /* mm */
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION "ics.section.profile_section"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_KIND "ics.section.profile_section.kind"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE "ics.section.profile_section.profile"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_S1002 "ics.section.profile_section.profile.s1002"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_RAIL_60E1 "ics.section.profile_section.profile.rail_60e1"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_RAIL_60E1_INCLINATION \
    "ics.section.profile_section.profile.rail_60e1.inclination"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_ARC "ics.section.profile_section.profile.arc"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_ARC_RADIUS \
    "ics.section.profile_section.profile.arc.radius" /* mm */
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_ARC_SLOPE "ics.section.profile_section.profile.arc.slope"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_ARC_ENDS "ics.section.profile_section.profile.arc.ends"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_ARC_ENDS_FROM \
    "ics.section.profile_section.profile.arc.ends.from"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_ARC_ENDS_TO "ics.section.profile_section.profile.arc.ends.to"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_CONE "ics.section.profile_section.profile.cone"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_CONE_SLOPE "ics.section.profile_section.profile.cone.slope"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_CONE_ENDS "ics.section.profile_section.profile.cone.ends"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_CONE_ENDS_FROM \
    "ics.section.profile_section.profile.cone.ends.from"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_CONE_ENDS_TO \
    "ics.section.profile_section.profile.cone.ends.to"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_STANDARD "ics.section.profile_section.profile.standard"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_STANDARD_NAME \
    "ics.section.profile_section.profile.standard.name"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_STANDARD_INCLINATION \
    "ics.section.profile_section.profile.standard.inclination"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_POINTS "ics.section.profile_section.profile.points"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_UNIT "ics.section.profile_section.profile.unit"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_MIRROR_Y "ics.section.profile_section.profile.mirror_y"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_MIRROR_Z "ics.section.profile_section.profile.mirror_z"
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_PROFILE_SMOOTHING_LENGTH \
    "ics.section.profile_section.profile.smoothing_length"                                  /* mm */
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_DEPTH "ics.section.profile_section.depth" /* mm */
#define CONTACTD_PATH_ICS_SECTION_PROFILE_SECTION_FROM "ics.section.profile_section.from"   /* mm */
#define CONTACTD_PATH_ICS_SECTION_SIZE "ics.section.size"
#define CONTACTD_PATH_ICS_SECTION_TURN "ics.section.turn" /* rad */
#define CONTACTD_PATH_ICS_SECTION_FREE "ics.section.free"
#define CONTACTD_PATH_ICS_LAYERS "ics.layers"
#define CONTACTD_PATH_ICS_LAYERS_THICKNESS "ics.layers[%d].thickness" /* mm */
#define CONTACTD_PATH_ICS_LAYERS_G "ics.layers[%d].G"                 /* N/mm^2 */
#define CONTACTD_PATH_ICS_LAYERS_NU "ics.layers[%d].nu"
#define CONTACTD_PATH_ICS_BASE "ics.base"
#define CONTACTD_PATH_ICS_BASE_G "ics.base.G" /* N/mm^2 */
#define CONTACTD_PATH_ICS_BASE_NU "ics.base.nu"
#define CONTACTD_PATH_ICS_BASE_RIGID "ics.base.rigid"
#define CONTACTD_PATH_ICS_LINE_CONTACT "ics.line_contact"
#define CONTACTD_PATH_ICS_LINE_CONTACT_DATUM "ics.line_contact.datum" /* mm */
#define CONTACTD_PATH_ICS_ACCURACY "ics.accuracy"
#define CONTACTD_PATH_ICS_ANY_NU "ics.any_nu"
#define CONTACTD_PATH_ICS_MESH "ics.mesh"
#define CONTACTD_PATH_ICS_ORDER "ics.order"
#define CONTACTD_PATH_ICS_L_OVER_H "ics.l_over_h"
#define CONTACTD_PATH_ICS_H_OVER_HS "ics.h_over_hs"
#define CONTACTD_PATH_ICS_F "ics.f"
#define CONTACTD_PATH_ICS_T1_OVER_HS "ics.t1_over_hs"
#define CONTACTD_PATH_ICS_CAPITAL_L_OVER_H "ics.L_over_h"
#define CONTACTD_PATH_ICS_DIAGONAL "ics.diagonal"
#define CONTACTD_PATH_ICS_MAX_DOFS "ics.max_dofs"
#define CONTACTD_PATH_ICS_FAR_BOUNDARY "ics.far_boundary"
#define CONTACTD_PATH_ICS_SAMPLING "ics.sampling"
#define CONTACTD_PATH_ICS_SOLVER "ics.solver"
#define CONTACTD_PATH_ICS_STOPPING_CRITERION "ics.stopping_criterion"
#define CONTACTD_PATH_ICS_TOLERANCE "ics.tolerance"
#define CONTACTD_PATH_ICS_MAX_ITERATIONS "ics.max_iterations"
#define CONTACTD_PATH_ICS_STRENGTH_THRESHOLD "ics.strength_threshold"
#define CONTACTD_PATH_GAP "gap"
#define CONTACTD_PATH_GAP_PARABOLOID "gap.paraboloid"
#define CONTACTD_PATH_GAP_PARABOLOID_RX "gap.paraboloid.Rx" /* mm */
#define CONTACTD_PATH_GAP_PARABOLOID_RY "gap.paraboloid.Ry" /* mm */
#define CONTACTD_PATH_GAP_SEMI_AXES "gap.semi_axes"
#define CONTACTD_PATH_GAP_SEMI_AXES_A "gap.semi_axes.a" /* mm */
#define CONTACTD_PATH_GAP_SEMI_AXES_B "gap.semi_axes.b" /* mm */
#define CONTACTD_PATH_GAP_HALF_ELLIPSES "gap.half_ellipses"
#define CONTACTD_PATH_GAP_HALF_ELLIPSES_A "gap.half_ellipses.a"                   /* mm */
#define CONTACTD_PATH_GAP_HALF_ELLIPSES_B_NEGATIVE "gap.half_ellipses.b_negative" /* mm */
#define CONTACTD_PATH_GAP_HALF_ELLIPSES_B_POSITIVE "gap.half_ellipses.b_positive" /* mm */
#define CONTACTD_PATH_GAP_ARRAY "gap.array"
#define CONTACTD_PATH_APPROACH "approach" /* mm */
#define CONTACTD_PATH_FN "Fn"             /* N */
#define CONTACTD_PATH_MODEL "model"
#define CONTACTD_PATH_NORMAL_MODEL "normal_model"
#define CONTACTD_PATH_SIMPLIFIED "simplified"
#define CONTACTD_PATH_SIMPLIFIED_SLOPE "simplified.slope"
#define CONTACTD_PATH_SIMPLIFIED_SLOPE_K0 "simplified.slope.k0"
#define CONTACTD_PATH_SIMPLIFIED_SLOPE_ALPHA "simplified.slope.alpha"
#define CONTACTD_PATH_SIMPLIFIED_SLOPE_BETA "simplified.slope.beta"
#define CONTACTD_PATH_SIMPLIFIED_BOUND "simplified.bound"
#define CONTACTD_PATH_SIMPLIFIED_ON_ELEMENTS "simplified.on_elements"
#define CONTACTD_PATH_SIMPLIFIED_BLENDED "simplified.blended"
#define CONTACTD_PATH_SIMPLIFIED_COEFFICIENTS "simplified.coefficients"
#define CONTACTD_PATH_SIMPLIFIED_K_ADHESION "simplified.k_adhesion"
#define CONTACTD_PATH_SIMPLIFIED_K_SLIP "simplified.k_slip"
#define CONTACTD_PATH_SHEET_FLEXIBILITY "sheet_flexibility" /* mm^3/N */
#define CONTACTD_PATH_TEMPERATURE "temperature"
#define CONTACTD_PATH_TEMPERATURE_UPPER "temperature.upper"
#define CONTACTD_PATH_TEMPERATURE_UPPER_BULK_TEMPERATURE "temperature.upper.bulk_temperature" /* degC */
#define CONTACTD_PATH_TEMPERATURE_UPPER_CONDUCTIVITY "temperature.upper.conductivity"         /* W/(m K) */
#define CONTACTD_PATH_TEMPERATURE_UPPER_HEAT_CAPACITY "temperature.upper.heat_capacity"       /* J/(kg K) */
#define CONTACTD_PATH_TEMPERATURE_UPPER_DENSITY "temperature.upper.density"                   /* kg/m^3 */
#define CONTACTD_PATH_TEMPERATURE_LOWER "temperature.lower"
#define CONTACTD_PATH_TEMPERATURE_LOWER_BULK_TEMPERATURE "temperature.lower.bulk_temperature" /* degC */
#define CONTACTD_PATH_TEMPERATURE_LOWER_CONDUCTIVITY "temperature.lower.conductivity"         /* W/(m K) */
#define CONTACTD_PATH_TEMPERATURE_LOWER_HEAT_CAPACITY "temperature.lower.heat_capacity"       /* J/(kg K) */
#define CONTACTD_PATH_TEMPERATURE_LOWER_DENSITY "temperature.lower.density"                   /* kg/m^3 */
#define CONTACTD_PATH_TEMPERATURE_PLASTIC_SHARE "temperature.plastic_share"
#define CONTACTD_PATH_WEAR "wear"
#define CONTACTD_PATH_WEAR_ENERGY "wear.energy"
#define CONTACTD_PATH_WEAR_LAWS "wear.laws"
#define CONTACTD_PATH_WEAR_LAWS_NAME "wear.laws[%d].name"
#define CONTACTD_PATH_WEAR_LAWS_SOURCE "wear.laws[%d].source"
#define CONTACTD_PATH_WEAR_LAWS_BODY "wear.laws[%d].body"
#define CONTACTD_PATH_WEAR_LAWS_RANGE "wear.laws[%d].range"
#define CONTACTD_PATH_WEAR_LAWS_RANGE_LEAST "wear.laws[%d].range.least"
#define CONTACTD_PATH_WEAR_LAWS_RANGE_MOST "wear.laws[%d].range.most"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD "wear.laws[%d].archard"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_HARDNESS "wear.laws[%d].archard.hardness" /* N/mm^2 */
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_MILD "wear.laws[%d].archard.mild"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEVERE "wear.laws[%d].archard.severe"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEVERE_K "wear.laws[%d].archard.severe.k"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEVERE_VELOCITY "wear.laws[%d].archard.severe.velocity"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEVERE_VELOCITY_LEAST "wear.laws[%d].archard.severe.velocity.least"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEVERE_VELOCITY_MOST "wear.laws[%d].archard.severe.velocity.most"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEIZURE "wear.laws[%d].archard.seizure"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEIZURE_K "wear.laws[%d].archard.seizure.k"
#define CONTACTD_PATH_WEAR_LAWS_ARCHARD_SEIZURE_PRESSURE "wear.laws[%d].archard.seizure.pressure"
#define CONTACTD_PATH_WEAR_LAWS_ENERGY "wear.laws[%d].energy"
#define CONTACTD_PATH_WEAR_LAWS_ENERGY_COEFFICIENT "wear.laws[%d].energy.coefficient" /* mm^3/J */
#define CONTACTD_PATH_WEAR_LAWS_USFD "wear.laws[%d].usfd"
#define CONTACTD_PATH_WEAR_LAWS_USFD_PIECES "wear.laws[%d].usfd.pieces"
#define CONTACTD_PATH_WEAR_LAWS_USFD_PIECES_FROM "wear.laws[%d].usfd.pieces[%d].from"
#define CONTACTD_PATH_WEAR_LAWS_USFD_PIECES_VALUE "wear.laws[%d].usfd.pieces[%d].value"
#define CONTACTD_PATH_WEAR_LAWS_USFD_PIECES_SLOPE "wear.laws[%d].usfd.pieces[%d].slope"
#define CONTACTD_PATH_WEAR_LAWS_USFD_DENSITY "wear.laws[%d].usfd.density" /* kg/m^3 */
#define CONTACTD_PATH_WEAR_LAWS_BR "wear.laws[%d].br"
#define CONTACTD_PATH_WEAR_LAWS_BR_PIECES "wear.laws[%d].br.pieces"
#define CONTACTD_PATH_WEAR_LAWS_BR_PIECES_FROM "wear.laws[%d].br.pieces[%d].from"
#define CONTACTD_PATH_WEAR_LAWS_BR_PIECES_VALUE "wear.laws[%d].br.pieces[%d].value"
#define CONTACTD_PATH_WEAR_LAWS_BR_PIECES_SLOPE "wear.laws[%d].br.pieces[%d].slope"
#define CONTACTD_PATH_WEAR_LAWS_ZOBORY "wear.laws[%d].zobory"
#define CONTACTD_PATH_WEAR_LAWS_ZOBORY_PIECES "wear.laws[%d].zobory.pieces"
#define CONTACTD_PATH_WEAR_LAWS_ZOBORY_PIECES_FROM "wear.laws[%d].zobory.pieces[%d].from"
#define CONTACTD_PATH_WEAR_LAWS_ZOBORY_PIECES_VALUE "wear.laws[%d].zobory.pieces[%d].value"
#define CONTACTD_PATH_WEAR_LAWS_ZOBORY_PIECES_SLOPE "wear.laws[%d].zobory.pieces[%d].slope"
#define CONTACTD_PATH_WEAR_LAWS_ZOBORY_DENSITY "wear.laws[%d].zobory.density" /* kg/m^3 */
#define CONTACTD_PATH_WEAR_LAWS_ZONES "wear.laws[%d].zones"
#define CONTACTD_PATH_WEAR_LAWS_ZONES_ANGLE "wear.laws[%d].zones[%d].angle" /* rad */
#define CONTACTD_PATH_WEAR_LAWS_ZONES_FACTOR "wear.laws[%d].zones[%d].factor"
#define CONTACTD_PATH_FATIGUE "fatigue"
#define CONTACTD_PATH_FATIGUE_BODY "fatigue.body"
#define CONTACTD_PATH_FATIGUE_STRENGTH "fatigue.strength"
#define CONTACTD_PATH_FATIGUE_STRENGTH_NAME "fatigue.strength.name"
#define CONTACTD_PATH_FATIGUE_STRENGTH_SOURCE "fatigue.strength.source"
#define CONTACTD_PATH_FATIGUE_STRENGTH_SHEAR_YIELD "fatigue.strength.shear_yield" /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_STRENGTH_A_DV "fatigue.strength.a_DV"
#define CONTACTD_PATH_FATIGUE_STRENGTH_TAU_E "fatigue.strength.tau_e" /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_DAMAGES "fatigue.damages"
#define CONTACTD_PATH_FATIGUE_DAMAGES_NAME "fatigue.damages[%d].name"
#define CONTACTD_PATH_FATIGUE_DAMAGES_SOURCE "fatigue.damages[%d].source"
#define CONTACTD_PATH_FATIGUE_DAMAGES_RANGE "fatigue.damages[%d].range"
#define CONTACTD_PATH_FATIGUE_DAMAGES_RANGE_LEAST "fatigue.damages[%d].range.least"
#define CONTACTD_PATH_FATIGUE_DAMAGES_RANGE_MOST "fatigue.damages[%d].range.most"
#define CONTACTD_PATH_FATIGUE_DAMAGES_PIECES "fatigue.damages[%d].pieces"
#define CONTACTD_PATH_FATIGUE_DAMAGES_PIECES_FROM "fatigue.damages[%d].pieces[%d].from"
#define CONTACTD_PATH_FATIGUE_DAMAGES_PIECES_VALUE "fatigue.damages[%d].pieces[%d].value"
#define CONTACTD_PATH_FATIGUE_DAMAGES_PIECES_SLOPE "fatigue.damages[%d].pieces[%d].slope"
#define CONTACTD_PATH_FATIGUE_PASSAGE "fatigue.passage"
#define CONTACTD_PATH_FATIGUE_PASSAGE_DEPTHS "fatigue.passage.depths"
#define CONTACTD_PATH_FATIGUE_PASSAGE_RESIDUAL "fatigue.passage.residual"
#define CONTACTD_PATH_FATIGUE_PASSAGE_RESIDUAL_DEPTH "fatigue.passage.residual[%d].depth" /* mm */
#define CONTACTD_PATH_FATIGUE_PASSAGE_RESIDUAL_XX "fatigue.passage.residual[%d].xx"       /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_PASSAGE_RESIDUAL_YY "fatigue.passage.residual[%d].yy"       /* N/mm^2 */
#define CONTACTD_PATH_FRICTION "friction"
#define CONTACTD_PATH_FRICTION_MU "friction.mu"
#define CONTACTD_PATH_FRICTION_KINETIC "friction.kinetic"
#define CONTACTD_PATH_FRICTION_KINETIC_LAW "friction.kinetic.law"
#define CONTACTD_PATH_FRICTION_KINETIC_MU "friction.kinetic.mu"
#define CONTACTD_PATH_FRICTION_KINETIC_SLIP_VELOCITY "friction.kinetic.slip_velocity" /* mm/s */
#define CONTACTD_PATH_FRICTION_KINETIC_START "friction.kinetic.start"
#define CONTACTD_PATH_FRICTION_KINETIC_SECOND "friction.kinetic.second"
#define CONTACTD_PATH_FRICTION_KINETIC_SECOND_FALL "friction.kinetic.second.fall"
#define CONTACTD_PATH_FRICTION_KINETIC_SECOND_SLIP_VELOCITY "friction.kinetic.second.slip_velocity" /* mm/s */
#define CONTACTD_PATH_FRICTION_KINETIC_MEMORY "friction.kinetic.memory"
#define CONTACTD_PATH_FRICTION_KINETIC_MEMORY_DISTANCE "friction.kinetic.memory.distance"             /* mm */
#define CONTACTD_PATH_FRICTION_KINETIC_MEMORY_LEAST_VELOCITY "friction.kinetic.memory.least_velocity" /* mm/s */
#define CONTACTD_PATH_FRICTION_LAYER "friction.layer"
#define CONTACTD_PATH_FRICTION_LAYER_FLEXIBILITY "friction.layer.flexibility"   /* mm^3/N */
#define CONTACTD_PATH_FRICTION_LAYER_YIELD_STRESS "friction.layer.yield_stress" /* N/mm^2 */
#define CONTACTD_PATH_FRICTION_LAYER_HARDENING "friction.layer.hardening"       /* N/mm^3 */
#define CONTACTD_PATH_FRICTION_LAYER_RESIDUAL "friction.layer.residual"
#define CONTACTD_PATH_FRICTION_TEMPERATURE "friction.temperature"
#define CONTACTD_PATH_FRICTION_TEMPERATURE_CHANGE "friction.temperature.change"
#define CONTACTD_PATH_FRICTION_TEMPERATURE_REFERENCE "friction.temperature.reference" /* degC */
#define CONTACTD_PATH_FRICTION_TEMPERATURE_RANGE "friction.temperature.range"         /* K */
#define CONTACTD_PATH_FRICTION_TEMPERATURE_MEMORY "friction.temperature.memory"
#define CONTACTD_PATH_FRICTION_TEMPERATURE_MEMORY_DISTANCE "friction.temperature.memory.distance" /* mm */
#define CONTACTD_PATH_FRICTION_TEMPERATURE_MEMORY_LEAST_VELOCITY "friction.temperature.memory.least_velocity"
#define CONTACTD_PATH_FRICTION_RIGID_SHIFT "friction.rigid_shift"
#define CONTACTD_PATH_FRICTION_RIGID_SHIFT_X "friction.rigid_shift.x"
#define CONTACTD_PATH_FRICTION_RIGID_SHIFT_Y "friction.rigid_shift.y"
#define CONTACTD_PATH_FRICTION_ROTATION "friction.rotation" /* rad */
#define CONTACTD_PATH_FRICTION_DURATION "friction.duration" /* s */
#define CONTACTD_PATH_FRICTION_FORCE "friction.force"
#define CONTACTD_PATH_FRICTION_FORCE_FX "friction.force.Fx"
#define CONTACTD_PATH_FRICTION_FORCE_FY "friction.force.Fy"
#define CONTACTD_PATH_FRICTION_ROLLING "friction.rolling"
#define CONTACTD_PATH_FRICTION_ROLLING_XI "friction.rolling.xi"
#define CONTACTD_PATH_FRICTION_ROLLING_ETA "friction.rolling.eta"
#define CONTACTD_PATH_FRICTION_ROLLING_PHI "friction.rolling.phi" /* rad/mm */
#define CONTACTD_PATH_FRICTION_ROLLING_CHI "friction.rolling.chi" /* rad */
#define CONTACTD_PATH_FRICTION_ROLLING_DQ "friction.rolling.dq"   /* mm */
#define CONTACTD_PATH_FRICTION_ROLLING_SPIN_OFFSET "friction.rolling.spin_offset"
#define CONTACTD_PATH_FRICTION_ROLLING_KIND "friction.rolling.kind"
#define CONTACTD_PATH_FRICTION_ROLLING_STEPS "friction.rolling.steps"
#define CONTACTD_PATH_FRICTION_ROLLING_VELOCITY "friction.rolling.velocity" /* mm/s */
#define CONTACTD_PATH_FRICTION_ROLLING_FORCE "friction.rolling.force"
#define CONTACTD_PATH_FRICTION_ROLLING_FORCE_FX "friction.rolling.force.Fx"
#define CONTACTD_PATH_FRICTION_ROLLING_FORCE_FY "friction.rolling.force.Fy"
#define CONTACTD_PATH_FRICTION_RIGID_SLIP "friction.rigid_slip"
#define CONTACTD_PATH_FRICTION_RIGID_SLIP_X "friction.rigid_slip.x"
#define CONTACTD_PATH_FRICTION_RIGID_SLIP_Y "friction.rigid_slip.y"
#define CONTACTD_PATH_PREVIOUS "previous"
#define CONTACTD_PATH_PREVIOUS_PRESSURE "previous.pressure"
#define CONTACTD_PATH_PREVIOUS_TRACTION_X "previous.traction_x"
#define CONTACTD_PATH_PREVIOUS_TRACTION_Y "previous.traction_y"
#define CONTACTD_PATH_PREVIOUS_YIELD_STRESS "previous.yield_stress"
#define CONTACTD_PATH_PREVIOUS_FRICTION_COEFFICIENT "previous.friction_coefficient"
#define CONTACTD_PATH_COLUMNS "columns"
#define CONTACTD_PATH_COLUMNS_FRAMES "columns.frames"
#define CONTACTD_PATH_COLUMNS_DIRECTION "columns.direction" /* rad */
#define CONTACTD_PATH_COLUMNS_ORIGIN "columns.origin"
#define CONTACTD_PATH_COLUMNS_ORIGIN_Y "columns.origin.y"
#define CONTACTD_PATH_COLUMNS_ORIGIN_Z "columns.origin.z"
#define CONTACTD_PATH_REGIONS "regions"
#define CONTACTD_PATH_REGIONS_LIMITS "regions.limits"
#define CONTACTD_PATH_REGIONS_LIMITS_X "regions.limits[%d].x"
#define CONTACTD_PATH_REGIONS_LIMITS_X_FROM "regions.limits[%d].x.from"
#define CONTACTD_PATH_REGIONS_LIMITS_X_TO "regions.limits[%d].x.to"
#define CONTACTD_PATH_REGIONS_LIMITS_Y "regions.limits[%d].y"
#define CONTACTD_PATH_REGIONS_LIMITS_Y_FROM "regions.limits[%d].y.from"
#define CONTACTD_PATH_REGIONS_LIMITS_Y_TO "regions.limits[%d].y.to"
#define CONTACTD_PATH_REGIONS_SHARES "regions.shares"
#define CONTACTD_PATH_ACCURACY "accuracy"
#define CONTACTD_PATH_SETTINGS "settings"
#define CONTACTD_PATH_SETTINGS_NORMAL "settings.normal"
#define CONTACTD_PATH_SETTINGS_NORMAL_TOLERANCE "settings.normal.tolerance"
#define CONTACTD_PATH_SETTINGS_NORMAL_MAX_ITERATIONS "settings.normal.max_iterations"
#define CONTACTD_PATH_SETTINGS_TANGENTIAL "settings.tangential"
#define CONTACTD_PATH_SETTINGS_TANGENTIAL_TOLERANCE "settings.tangential.tolerance"
#define CONTACTD_PATH_SETTINGS_TANGENTIAL_MAX_ITERATIONS "settings.tangential.max_iterations"
#define CONTACTD_PATH_SETTINGS_TANGENTIAL_SOLVER "settings.tangential.solver"
#define CONTACTD_PATH_SETTINGS_OUTER "settings.outer"
#define CONTACTD_PATH_SETTINGS_OUTER_TOLERANCE "settings.outer.tolerance"
#define CONTACTD_PATH_SETTINGS_OUTER_MAX_ITERATIONS "settings.outer.max_iterations"
#define CONTACTD_PATH_DERIVATIVES "derivatives"
#define CONTACTD_PATH_DISPLACEMENTS "displacements"
#define CONTACTD_PATH_LEASE_SECONDS "lease_seconds" /* s */
#define CONTACTD_PATH_ACCEPT_UNCONVERGED "accept_unconverged"

/* --- results of a contact --- */
#define CONTACTD_PATH_STEP "step"
#define CONTACTD_PATH_FORCES "forces"
#define CONTACTD_PATH_FORCES_FN "forces.Fn" /* N */
#define CONTACTD_PATH_FORCES_FX "forces.Fx" /* N */
#define CONTACTD_PATH_FORCES_FY "forces.Fy" /* N */
#define CONTACTD_PATH_FORCES_MZ "forces.Mz" /* N mm */
#define CONTACTD_PATH_RESULTANT "resultant"
#define CONTACTD_PATH_RESULTANT_FX "resultant.Fx" /* N */
#define CONTACTD_PATH_RESULTANT_FY "resultant.Fy" /* N */
#define CONTACTD_PATH_RESULTANT_FZ "resultant.Fz" /* N */
#define CONTACTD_PATH_RESULTANT_MX "resultant.Mx" /* N mm */
#define CONTACTD_PATH_RESULTANT_MY "resultant.My" /* N mm */
#define CONTACTD_PATH_RESULTANT_MZ "resultant.Mz" /* N mm */
#define CONTACTD_PATH_PMAX "pmax"                 /* N/mm^2 */
#define CONTACTD_PATH_AREA "area"
#define CONTACTD_PATH_AREA_CONTACT "area.contact"   /* mm^2 */
#define CONTACTD_PATH_AREA_ADHESION "area.adhesion" /* mm^2 */
#define CONTACTD_PATH_AREA_SLIP "area.slip"         /* mm^2 */
#define CONTACTD_PATH_AREA_FLOW "area.flow"         /* mm^2 */
#define CONTACTD_PATH_ELEMENTS "elements"
#define CONTACTD_PATH_ELEMENTS_CONTACT "elements.contact"
#define CONTACTD_PATH_ELEMENTS_ADHESION "elements.adhesion"
#define CONTACTD_PATH_ELEMENTS_SLIP "elements.slip"
#define CONTACTD_PATH_ELEMENTS_FLOW "elements.flow"
#define CONTACTD_PATH_ELEMENTS_BORDER "elements.border"
#define CONTACTD_PATH_ELEMENT_DIVISION "element_division"
#define CONTACTD_PATH_PRESSURE "pressure"
#define CONTACTD_PATH_TRACTION_X "traction_x"
#define CONTACTD_PATH_TRACTION_Y "traction_y"
#define CONTACTD_PATH_SLIP_X "slip_x"
#define CONTACTD_PATH_SLIP_Y "slip_y"
#define CONTACTD_PATH_FLOW_X "flow_x"
#define CONTACTD_PATH_FLOW_Y "flow_y"
#define CONTACTD_PATH_YIELD_STRESS "yield_stress"
#define CONTACTD_PATH_FRICTION_COEFFICIENT "friction_coefficient"
#define CONTACTD_PATH_FRICTIONAL_WORK "frictional_work"   /* N mm */
#define CONTACTD_PATH_FRICTIONAL_POWER "frictional_power" /* N mm/s */
#define CONTACTD_PATH_PLASTIC_WORK "plastic_work"         /* N mm */
#define CONTACTD_PATH_PLASTIC_POWER "plastic_power"       /* N mm/s */
#define CONTACTD_PATH_LARGEST_FLOW "largest_flow"
#define CONTACTD_PATH_MOTION "motion"
#define CONTACTD_PATH_MOTION_RIGID_SHIFT "motion.rigid_shift"
#define CONTACTD_PATH_MOTION_RIGID_SHIFT_X "motion.rigid_shift.x"
#define CONTACTD_PATH_MOTION_RIGID_SHIFT_Y "motion.rigid_shift.y"
#define CONTACTD_PATH_MOTION_ROTATION "motion.rotation" /* rad */
#define CONTACTD_PATH_MOTION_DURATION "motion.duration" /* s */
#define CONTACTD_PATH_MOTION_FORCE "motion.force"
#define CONTACTD_PATH_MOTION_FORCE_FX "motion.force.Fx"
#define CONTACTD_PATH_MOTION_FORCE_FY "motion.force.Fy"
#define CONTACTD_PATH_MOTION_XI "motion.xi"
#define CONTACTD_PATH_MOTION_ETA "motion.eta"
#define CONTACTD_PATH_MOTION_PHI "motion.phi" /* rad/mm */
#define CONTACTD_PATH_MOTION_CHI "motion.chi" /* rad */
#define CONTACTD_PATH_MOTION_DQ "motion.dq"   /* mm */
#define CONTACTD_PATH_MOTION_SPIN_OFFSET "motion.spin_offset"
#define CONTACTD_PATH_MOTION_KIND "motion.kind"
#define CONTACTD_PATH_MOTION_STEPS "motion.steps"
#define CONTACTD_PATH_MOTION_VELOCITY "motion.velocity" /* mm/s */
#define CONTACTD_PATH_UPPER_SPEED "upper_speed"         /* mm/s */
#define CONTACTD_PATH_DISPLACEMENT_X "displacement_x"
#define CONTACTD_PATH_DISPLACEMENT_Y "displacement_y"
#define CONTACTD_PATH_DISPLACEMENT_Z "displacement_z"
#define CONTACTD_PATH_UPPER_TEMPERATURE "upper_temperature"
#define CONTACTD_PATH_LOWER_TEMPERATURE "lower_temperature"
#define CONTACTD_PATH_PRESSURE_BY_APPROACH "pressure_by_approach"
#define CONTACTD_PATH_TEMPERATURE_LARGEST "temperature.largest"             /* degC */
#define CONTACTD_PATH_TEMPERATURE_X "temperature.x"                         /* mm */
#define CONTACTD_PATH_TEMPERATURE_Y "temperature.y"                         /* mm */
#define CONTACTD_PATH_TEMPERATURE_LARGEST_UPPER "temperature.largest_upper" /* degC */
#define CONTACTD_PATH_TEMPERATURE_LARGEST_LOWER "temperature.largest_lower" /* degC */
#define CONTACTD_PATH_TEMPERATURE_RISE "temperature.rise"                   /* K */
#define CONTACTD_PATH_TEMPERATURE_HEAT_UPPER "temperature.heat_upper"       /* N mm/s */
#define CONTACTD_PATH_TEMPERATURE_HEAT_LOWER "temperature.heat_lower"       /* N mm/s */
#define CONTACTD_PATH_TEMPERATURE_PECLET "temperature.peclet"
#define CONTACTD_PATH_WEAR_CAPITAL_T_GAMMA "wear.T_gamma"                     /* N */
#define CONTACTD_PATH_WEAR_CAPITAL_T_GAMMA_WITH_SPIN "wear.T_gamma_with_spin" /* N */
#define CONTACTD_PATH_WEAR_DISSIPATION "wear.dissipation"                     /* N */
#define CONTACTD_PATH_WEAR_FACTOR "wear.factor"
#define CONTACTD_PATH_WEAR_LARGEST_PRESSURE_SLIP "wear.largest_pressure_slip"       /* N/mm^2 */
#define CONTACTD_PATH_WEAR_LARGEST_DISSIPATION "wear.largest_dissipation"           /* N/mm^2 */
#define CONTACTD_PATH_WEAR_LARGEST_SLIDING_VELOCITY "wear.largest_sliding_velocity" /* mm/s */
#define CONTACTD_PATH_WEAR_ROWS "wear.rows"
#define CONTACTD_PATH_WEAR_ROWS_Y "wear.rows[%d].y"                         /* mm */
#define CONTACTD_PATH_WEAR_ROWS_Z "wear.rows[%d].z"                         /* mm */
#define CONTACTD_PATH_WEAR_ROWS_ANGLE "wear.rows[%d].angle"                 /* rad */
#define CONTACTD_PATH_WEAR_ROWS_DISSIPATION "wear.rows[%d].dissipation"     /* N/mm */
#define CONTACTD_PATH_WEAR_ROWS_PRESSURE_SLIP "wear.rows[%d].pressure_slip" /* N/mm */
#define CONTACTD_PATH_WEAR_ROWS_DEPTHS "wear.rows[%d].depths"
#define CONTACTD_PATH_WEAR_LAWS_AREA "wear.laws[%d].area"   /* mm^2 */
#define CONTACTD_PATH_WEAR_LAWS_DEPTH "wear.laws[%d].depth" /* mm */
#define CONTACTD_PATH_WEAR_LAWS_ARGUMENT "wear.laws[%d].argument"
#define CONTACTD_PATH_FATIGUE_CAPITAL_T_GAMMA "fatigue.T_gamma" /* N */
#define CONTACTD_PATH_FATIGUE_TRACTION_COEFFICIENT "fatigue.traction_coefficient"
#define CONTACTD_PATH_FATIGUE_FORCE_ANGLE "fatigue.force_angle" /* rad */
#define CONTACTD_PATH_FATIGUE_DRIVEN "fatigue.driven"
#define CONTACTD_PATH_FATIGUE_FI_SURF "fatigue.FI_surf"
#define CONTACTD_PATH_FATIGUE_FI_SUB "fatigue.FI_sub" /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_LOAD "fatigue.load"
#define CONTACTD_PATH_FATIGUE_LIMIT "fatigue.limit"
#define CONTACTD_PATH_FATIGUE_SHEAR "fatigue.shear"
#define CONTACTD_PATH_FATIGUE_SHEAR_VALUE "fatigue.shear.value" /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_SHEAR_Y "fatigue.shear.y"         /* mm */
#define CONTACTD_PATH_FATIGUE_SHEAR_Z "fatigue.shear.z"         /* mm */
#define CONTACTD_PATH_FATIGUE_SHEAR_DEPTH "fatigue.shear.depth" /* mm */
#define CONTACTD_PATH_FATIGUE_VON_MISES "fatigue.von_mises"
#define CONTACTD_PATH_FATIGUE_VON_MISES_VALUE "fatigue.von_mises.value" /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_VON_MISES_Y "fatigue.von_mises.y"         /* mm */
#define CONTACTD_PATH_FATIGUE_VON_MISES_Z "fatigue.von_mises.z"         /* mm */
#define CONTACTD_PATH_FATIGUE_VON_MISES_DEPTH "fatigue.von_mises.depth" /* mm */
#define CONTACTD_PATH_FATIGUE_DANG_VAN "fatigue.dang_van"
#define CONTACTD_PATH_FATIGUE_DANG_VAN_VALUE "fatigue.dang_van.value" /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_DANG_VAN_Y "fatigue.dang_van.y"         /* mm */
#define CONTACTD_PATH_FATIGUE_DANG_VAN_Z "fatigue.dang_van.z"         /* mm */
#define CONTACTD_PATH_FATIGUE_DANG_VAN_DEPTH "fatigue.dang_van.depth" /* mm */
#define CONTACTD_PATH_FATIGUE_UTILISATION "fatigue.utilisation"
#define CONTACTD_PATH_FATIGUE_DAMAGES_VALUE "fatigue.damages[%d].value"
#define CONTACTD_PATH_FATIGUE_ROWS "fatigue.rows"
#define CONTACTD_PATH_FATIGUE_ROWS_Y "fatigue.rows[%d].y"                           /* mm */
#define CONTACTD_PATH_FATIGUE_ROWS_Z "fatigue.rows[%d].z"                           /* mm */
#define CONTACTD_PATH_FATIGUE_ROWS_ANGLE "fatigue.rows[%d].angle"                   /* rad */
#define CONTACTD_PATH_FATIGUE_ROWS_PRESSURE "fatigue.rows[%d].pressure"             /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_ROWS_TRACTION "fatigue.rows[%d].traction"             /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_ROWS_FORCE_X "fatigue.rows[%d].force_x"               /* N/mm */
#define CONTACTD_PATH_FATIGUE_ROWS_FORCE_Y "fatigue.rows[%d].force_y"               /* N/mm */
#define CONTACTD_PATH_FATIGUE_ROWS_SHEAR "fatigue.rows[%d].shear"                   /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_ROWS_SHEAR_DEPTH "fatigue.rows[%d].shear_depth"       /* mm */
#define CONTACTD_PATH_FATIGUE_ROWS_DANG_VAN "fatigue.rows[%d].dang_van"             /* N/mm^2 */
#define CONTACTD_PATH_FATIGUE_ROWS_DANG_VAN_DEPTH "fatigue.rows[%d].dang_van_depth" /* mm */
#define CONTACTD_PATH_ROLLING_RESISTANCE "rolling_resistance"
#define CONTACTD_PATH_ROLLING_RESISTANCE_FORCE "rolling_resistance.force"                           /* N */
#define CONTACTD_PATH_ROLLING_RESISTANCE_POWER "rolling_resistance.power"                           /* N mm/s */
#define CONTACTD_PATH_ROLLING_RESISTANCE_CENTRE_OF_PRESSURE "rolling_resistance.centre_of_pressure" /* mm */
#define CONTACTD_PATH_ROLLING_RESISTANCE_MOMENT "rolling_resistance.moment"                         /* N mm */
#define CONTACTD_PATH_ROLLING_RESISTANCE_DEFECT "rolling_resistance.defect"
#define CONTACTD_PATH_ELASTIC_ENERGY "elastic_energy" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_FX "derivatives.Fx"
#define CONTACTD_PATH_DERIVATIVES_FX_XI "derivatives.Fx.xi"
#define CONTACTD_PATH_DERIVATIVES_FX_ETA "derivatives.Fx.eta"
#define CONTACTD_PATH_DERIVATIVES_FX_PHI "derivatives.Fx.phi"
#define CONTACTD_PATH_DERIVATIVES_FX_RIGID_SHIFT "derivatives.Fx.rigid_shift"
#define CONTACTD_PATH_DERIVATIVES_FX_RIGID_SHIFT_X "derivatives.Fx.rigid_shift.x"
#define CONTACTD_PATH_DERIVATIVES_FX_RIGID_SHIFT_Y "derivatives.Fx.rigid_shift.y"
#define CONTACTD_PATH_DERIVATIVES_FX_ROTATION "derivatives.Fx.rotation"
#define CONTACTD_PATH_DERIVATIVES_FX_APPROACH "derivatives.Fx.approach"
#define CONTACTD_PATH_DERIVATIVES_FX_FN "derivatives.Fx.Fn"
#define CONTACTD_PATH_DERIVATIVES_FX_MU "derivatives.Fx.mu"
#define CONTACTD_PATH_DERIVATIVES_FY "derivatives.Fy"
#define CONTACTD_PATH_DERIVATIVES_FY_XI "derivatives.Fy.xi"
#define CONTACTD_PATH_DERIVATIVES_FY_ETA "derivatives.Fy.eta"
#define CONTACTD_PATH_DERIVATIVES_FY_PHI "derivatives.Fy.phi"
#define CONTACTD_PATH_DERIVATIVES_FY_RIGID_SHIFT "derivatives.Fy.rigid_shift"
#define CONTACTD_PATH_DERIVATIVES_FY_RIGID_SHIFT_X "derivatives.Fy.rigid_shift.x"
#define CONTACTD_PATH_DERIVATIVES_FY_RIGID_SHIFT_Y "derivatives.Fy.rigid_shift.y"
#define CONTACTD_PATH_DERIVATIVES_FY_ROTATION "derivatives.Fy.rotation"
#define CONTACTD_PATH_DERIVATIVES_FY_APPROACH "derivatives.Fy.approach"
#define CONTACTD_PATH_DERIVATIVES_FY_FN "derivatives.Fy.Fn"
#define CONTACTD_PATH_DERIVATIVES_FY_MU "derivatives.Fy.mu"
#define CONTACTD_PATH_DERIVATIVES_MZ "derivatives.Mz"
#define CONTACTD_PATH_DERIVATIVES_MZ_XI "derivatives.Mz.xi"
#define CONTACTD_PATH_DERIVATIVES_MZ_ETA "derivatives.Mz.eta"
#define CONTACTD_PATH_DERIVATIVES_MZ_PHI "derivatives.Mz.phi"
#define CONTACTD_PATH_DERIVATIVES_MZ_RIGID_SHIFT "derivatives.Mz.rigid_shift"
#define CONTACTD_PATH_DERIVATIVES_MZ_RIGID_SHIFT_X "derivatives.Mz.rigid_shift.x"
#define CONTACTD_PATH_DERIVATIVES_MZ_RIGID_SHIFT_Y "derivatives.Mz.rigid_shift.y"
#define CONTACTD_PATH_DERIVATIVES_MZ_ROTATION "derivatives.Mz.rotation"
#define CONTACTD_PATH_DERIVATIVES_MZ_APPROACH "derivatives.Mz.approach"
#define CONTACTD_PATH_DERIVATIVES_MZ_FN "derivatives.Mz.Fn"
#define CONTACTD_PATH_DERIVATIVES_MZ_MU "derivatives.Mz.mu"
#define CONTACTD_PATH_DERIVATIVES_FN "derivatives.Fn"
#define CONTACTD_PATH_DERIVATIVES_FN_XI "derivatives.Fn.xi"
#define CONTACTD_PATH_DERIVATIVES_FN_ETA "derivatives.Fn.eta"
#define CONTACTD_PATH_DERIVATIVES_FN_PHI "derivatives.Fn.phi"
#define CONTACTD_PATH_DERIVATIVES_FN_RIGID_SHIFT "derivatives.Fn.rigid_shift"
#define CONTACTD_PATH_DERIVATIVES_FN_RIGID_SHIFT_X "derivatives.Fn.rigid_shift.x"
#define CONTACTD_PATH_DERIVATIVES_FN_RIGID_SHIFT_Y "derivatives.Fn.rigid_shift.y"
#define CONTACTD_PATH_DERIVATIVES_FN_ROTATION "derivatives.Fn.rotation"
#define CONTACTD_PATH_DERIVATIVES_FN_APPROACH "derivatives.Fn.approach"
#define CONTACTD_PATH_DERIVATIVES_FN_FN "derivatives.Fn.Fn"
#define CONTACTD_PATH_DERIVATIVES_FN_MU "derivatives.Fn.mu"
#define CONTACTD_PATH_DERIVATIVES_APPROACH "derivatives.approach"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_XI "derivatives.approach.xi"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_ETA "derivatives.approach.eta"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_PHI "derivatives.approach.phi"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_RIGID_SHIFT "derivatives.approach.rigid_shift"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_RIGID_SHIFT_X "derivatives.approach.rigid_shift.x"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_RIGID_SHIFT_Y "derivatives.approach.rigid_shift.y"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_ROTATION "derivatives.approach.rotation"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_APPROACH "derivatives.approach.approach"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_FN "derivatives.approach.Fn"
#define CONTACTD_PATH_DERIVATIVES_APPROACH_MU "derivatives.approach.mu"
#define CONTACTD_PATH_WARNINGS "warnings"
#define CONTACTD_PATH_WARNINGS_AT "warnings[%d]"
#define CONTACTD_PATH_CONVERGED "converged"
#define CONTACTD_PATH_ICS_UPPER "ics.upper"
#define CONTACTD_PATH_ICS_UPPER_ORIGIN "ics.upper.origin"
#define CONTACTD_PATH_ICS_UPPER_KEY "ics.upper.key"
#define CONTACTD_PATH_ICS_UPPER_EVIDENCE "ics.upper.evidence"
#define CONTACTD_PATH_ICS_LOWER "ics.lower"
#define CONTACTD_PATH_ICS_LOWER_ORIGIN "ics.lower.origin"
#define CONTACTD_PATH_ICS_LOWER_KEY "ics.lower.key"
#define CONTACTD_PATH_ICS_LOWER_EVIDENCE "ics.lower.evidence"
#define CONTACTD_PATH_ICS_PAIR "ics.pair"
#define CONTACTD_PATH_ICS_PAIR_ORIGIN "ics.pair.origin"
#define CONTACTD_PATH_ICS_PAIR_KEY "ics.pair.key"
#define CONTACTD_PATH_ICS_PAIR_EVIDENCE "ics.pair.evidence"

/* --- inputs of a wheel --- */
#define CONTACTD_PATH_SETUP "setup"
#define CONTACTD_PATH_SETUP_SIDE "setup.side"
#define CONTACTD_PATH_SETUP_WHEEL "setup.wheel"
#define CONTACTD_PATH_SETUP_WHEEL_S1002 "setup.wheel.s1002"
#define CONTACTD_PATH_SETUP_WHEEL_RAIL_60E1 "setup.wheel.rail_60e1"
#define CONTACTD_PATH_SETUP_WHEEL_RAIL_60E1_INCLINATION "setup.wheel.rail_60e1.inclination"
#define CONTACTD_PATH_SETUP_WHEEL_ARC "setup.wheel.arc"
#define CONTACTD_PATH_SETUP_WHEEL_ARC_RADIUS "setup.wheel.arc.radius" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_ARC_SLOPE "setup.wheel.arc.slope"
#define CONTACTD_PATH_SETUP_WHEEL_ARC_ENDS "setup.wheel.arc.ends"
#define CONTACTD_PATH_SETUP_WHEEL_ARC_ENDS_FROM "setup.wheel.arc.ends.from"
#define CONTACTD_PATH_SETUP_WHEEL_ARC_ENDS_TO "setup.wheel.arc.ends.to"
#define CONTACTD_PATH_SETUP_WHEEL_CONE "setup.wheel.cone"
#define CONTACTD_PATH_SETUP_WHEEL_CONE_SLOPE "setup.wheel.cone.slope"
#define CONTACTD_PATH_SETUP_WHEEL_CONE_ENDS "setup.wheel.cone.ends"
#define CONTACTD_PATH_SETUP_WHEEL_CONE_ENDS_FROM "setup.wheel.cone.ends.from"
#define CONTACTD_PATH_SETUP_WHEEL_CONE_ENDS_TO "setup.wheel.cone.ends.to"
#define CONTACTD_PATH_SETUP_WHEEL_STANDARD "setup.wheel.standard"
#define CONTACTD_PATH_SETUP_WHEEL_STANDARD_NAME "setup.wheel.standard.name"
#define CONTACTD_PATH_SETUP_WHEEL_STANDARD_INCLINATION "setup.wheel.standard.inclination"
#define CONTACTD_PATH_SETUP_WHEEL_POINTS "setup.wheel.points"
#define CONTACTD_PATH_SETUP_WHEEL_UNIT "setup.wheel.unit"
#define CONTACTD_PATH_SETUP_WHEEL_MIRROR_Y "setup.wheel.mirror_y"
#define CONTACTD_PATH_SETUP_WHEEL_MIRROR_Z "setup.wheel.mirror_z"
#define CONTACTD_PATH_SETUP_WHEEL_SMOOTHING_LENGTH "setup.wheel.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_FILE "setup.wheel.file"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_NAME "setup.wheel.file.name"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_TEXT "setup.wheel.file.text"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_UNIT "setup.wheel.file.unit"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_MIRROR_Y "setup.wheel.file.mirror_y"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_MIRROR_Z "setup.wheel.file.mirror_z"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_SHIFT_Y "setup.wheel.file.shift_y"                   /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_FILE_SHIFT_Z "setup.wheel.file.shift_z"                   /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_FILE_SMOOTHING_LENGTH "setup.wheel.file.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_FILE_SMOOTHING_ORDER "setup.wheel.file.smoothing_order"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_SMOOTHING_LAMBDA "setup.wheel.file.smoothing_lambda" /* mm^3 */
#define CONTACTD_PATH_SETUP_WHEEL_FILE_KINKS "setup.wheel.file.kinks"
#define CONTACTD_PATH_SETUP_WHEEL_FILE_KINKS_ANGLE "setup.wheel.file.kinks.angle" /* rad */
#define CONTACTD_PATH_SETUP_WHEEL_FILE_KINKS_REST "setup.wheel.file.kinks.rest"   /* rad */
#define CONTACTD_PATH_SETUP_WHEEL_FILE_KINKS_WIDTH "setup.wheel.file.kinks.width" /* mm */
#define CONTACTD_PATH_SETUP_RAIL "setup.rail"
#define CONTACTD_PATH_SETUP_RAIL_S1002 "setup.rail.s1002"
#define CONTACTD_PATH_SETUP_RAIL_RAIL_60E1 "setup.rail.rail_60e1"
#define CONTACTD_PATH_SETUP_RAIL_RAIL_60E1_INCLINATION "setup.rail.rail_60e1.inclination"
#define CONTACTD_PATH_SETUP_RAIL_ARC "setup.rail.arc"
#define CONTACTD_PATH_SETUP_RAIL_ARC_RADIUS "setup.rail.arc.radius" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_ARC_SLOPE "setup.rail.arc.slope"
#define CONTACTD_PATH_SETUP_RAIL_ARC_ENDS "setup.rail.arc.ends"
#define CONTACTD_PATH_SETUP_RAIL_ARC_ENDS_FROM "setup.rail.arc.ends.from"
#define CONTACTD_PATH_SETUP_RAIL_ARC_ENDS_TO "setup.rail.arc.ends.to"
#define CONTACTD_PATH_SETUP_RAIL_CONE "setup.rail.cone"
#define CONTACTD_PATH_SETUP_RAIL_CONE_SLOPE "setup.rail.cone.slope"
#define CONTACTD_PATH_SETUP_RAIL_CONE_ENDS "setup.rail.cone.ends"
#define CONTACTD_PATH_SETUP_RAIL_CONE_ENDS_FROM "setup.rail.cone.ends.from"
#define CONTACTD_PATH_SETUP_RAIL_CONE_ENDS_TO "setup.rail.cone.ends.to"
#define CONTACTD_PATH_SETUP_RAIL_STANDARD "setup.rail.standard"
#define CONTACTD_PATH_SETUP_RAIL_STANDARD_NAME "setup.rail.standard.name"
#define CONTACTD_PATH_SETUP_RAIL_STANDARD_INCLINATION "setup.rail.standard.inclination"
#define CONTACTD_PATH_SETUP_RAIL_POINTS "setup.rail.points"
#define CONTACTD_PATH_SETUP_RAIL_UNIT "setup.rail.unit"
#define CONTACTD_PATH_SETUP_RAIL_MIRROR_Y "setup.rail.mirror_y"
#define CONTACTD_PATH_SETUP_RAIL_MIRROR_Z "setup.rail.mirror_z"
#define CONTACTD_PATH_SETUP_RAIL_SMOOTHING_LENGTH "setup.rail.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_FILE "setup.rail.file"
#define CONTACTD_PATH_SETUP_RAIL_FILE_NAME "setup.rail.file.name"
#define CONTACTD_PATH_SETUP_RAIL_FILE_TEXT "setup.rail.file.text"
#define CONTACTD_PATH_SETUP_RAIL_FILE_UNIT "setup.rail.file.unit"
#define CONTACTD_PATH_SETUP_RAIL_FILE_MIRROR_Y "setup.rail.file.mirror_y"
#define CONTACTD_PATH_SETUP_RAIL_FILE_MIRROR_Z "setup.rail.file.mirror_z"
#define CONTACTD_PATH_SETUP_RAIL_FILE_SHIFT_Y "setup.rail.file.shift_y"                   /* mm */
#define CONTACTD_PATH_SETUP_RAIL_FILE_SHIFT_Z "setup.rail.file.shift_z"                   /* mm */
#define CONTACTD_PATH_SETUP_RAIL_FILE_SMOOTHING_LENGTH "setup.rail.file.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_FILE_SMOOTHING_ORDER "setup.rail.file.smoothing_order"
#define CONTACTD_PATH_SETUP_RAIL_FILE_SMOOTHING_LAMBDA "setup.rail.file.smoothing_lambda" /* mm^3 */
#define CONTACTD_PATH_SETUP_RAIL_FILE_KINKS "setup.rail.file.kinks"
#define CONTACTD_PATH_SETUP_RAIL_FILE_KINKS_ANGLE "setup.rail.file.kinks.angle" /* rad */
#define CONTACTD_PATH_SETUP_RAIL_FILE_KINKS_REST "setup.rail.file.kinks.rest"   /* rad */
#define CONTACTD_PATH_SETUP_RAIL_FILE_KINKS_WIDTH "setup.rail.file.kinks.width" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES "setup.rail_slices"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_X "setup.rail_slices[%d].x" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE "setup.rail_slices[%d].profile"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_S1002 "setup.rail_slices[%d].profile.s1002"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_RAIL_60E1 "setup.rail_slices[%d].profile.rail_60e1"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_RAIL_60E1_INCLINATION \
    "setup.rail_slices[%d].profile.rail_60e1.inclination"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_ARC "setup.rail_slices[%d].profile.arc"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_ARC_RADIUS "setup.rail_slices[%d].profile.arc.radius" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_ARC_SLOPE "setup.rail_slices[%d].profile.arc.slope"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_ARC_ENDS "setup.rail_slices[%d].profile.arc.ends"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_ARC_ENDS_FROM "setup.rail_slices[%d].profile.arc.ends.from"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_ARC_ENDS_TO "setup.rail_slices[%d].profile.arc.ends.to"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_CONE "setup.rail_slices[%d].profile.cone"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_CONE_SLOPE "setup.rail_slices[%d].profile.cone.slope"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_CONE_ENDS "setup.rail_slices[%d].profile.cone.ends"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_CONE_ENDS_FROM "setup.rail_slices[%d].profile.cone.ends.from"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_CONE_ENDS_TO "setup.rail_slices[%d].profile.cone.ends.to"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_STANDARD "setup.rail_slices[%d].profile.standard"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_STANDARD_NAME "setup.rail_slices[%d].profile.standard.name"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_STANDARD_INCLINATION \
    "setup.rail_slices[%d].profile.standard.inclination"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_POINTS "setup.rail_slices[%d].profile.points"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_UNIT "setup.rail_slices[%d].profile.unit"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_MIRROR_Y "setup.rail_slices[%d].profile.mirror_y"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_MIRROR_Z "setup.rail_slices[%d].profile.mirror_z"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_SMOOTHING_LENGTH \
    "setup.rail_slices[%d].profile.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE "setup.rail_slices[%d].profile.file"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_NAME "setup.rail_slices[%d].profile.file.name"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_TEXT "setup.rail_slices[%d].profile.file.text"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_UNIT "setup.rail_slices[%d].profile.file.unit"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_MIRROR_Y "setup.rail_slices[%d].profile.file.mirror_y"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_MIRROR_Z "setup.rail_slices[%d].profile.file.mirror_z"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_SHIFT_Y "setup.rail_slices[%d].profile.file.shift_y" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_SHIFT_Z "setup.rail_slices[%d].profile.file.shift_z" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_SMOOTHING_LENGTH \
    "setup.rail_slices[%d].profile.file.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_SMOOTHING_ORDER \
    "setup.rail_slices[%d].profile.file.smoothing_order"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_SMOOTHING_LAMBDA \
    "setup.rail_slices[%d].profile.file.smoothing_lambda" /* mm^3 */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_KINKS "setup.rail_slices[%d].profile.file.kinks"
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_KINKS_ANGLE \
    "setup.rail_slices[%d].profile.file.kinks.angle" /* rad */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_KINKS_REST \
    "setup.rail_slices[%d].profile.file.kinks.rest" /* rad */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_PROFILE_FILE_KINKS_WIDTH \
    "setup.rail_slices[%d].profile.file.kinks.width" /* mm */
#define CONTACTD_PATH_SETUP_RAIL_SLICES_FEATURES "setup.rail_slices[%d].features"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES "setup.wheel_slices"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_ANGLE "setup.wheel_slices[%d].angle" /* rad */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE "setup.wheel_slices[%d].profile"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_S1002 "setup.wheel_slices[%d].profile.s1002"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_RAIL_60E1 "setup.wheel_slices[%d].profile.rail_60e1"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_RAIL_60E1_INCLINATION \
    "setup.wheel_slices[%d].profile.rail_60e1.inclination"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_ARC "setup.wheel_slices[%d].profile.arc"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_ARC_RADIUS "setup.wheel_slices[%d].profile.arc.radius" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_ARC_SLOPE "setup.wheel_slices[%d].profile.arc.slope"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_ARC_ENDS "setup.wheel_slices[%d].profile.arc.ends"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_ARC_ENDS_FROM "setup.wheel_slices[%d].profile.arc.ends.from"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_ARC_ENDS_TO "setup.wheel_slices[%d].profile.arc.ends.to"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_CONE "setup.wheel_slices[%d].profile.cone"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_CONE_SLOPE "setup.wheel_slices[%d].profile.cone.slope"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_CONE_ENDS "setup.wheel_slices[%d].profile.cone.ends"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_CONE_ENDS_FROM "setup.wheel_slices[%d].profile.cone.ends.from"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_CONE_ENDS_TO "setup.wheel_slices[%d].profile.cone.ends.to"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_STANDARD "setup.wheel_slices[%d].profile.standard"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_STANDARD_NAME "setup.wheel_slices[%d].profile.standard.name"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_STANDARD_INCLINATION \
    "setup.wheel_slices[%d].profile.standard.inclination"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_POINTS "setup.wheel_slices[%d].profile.points"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_UNIT "setup.wheel_slices[%d].profile.unit"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_MIRROR_Y "setup.wheel_slices[%d].profile.mirror_y"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_MIRROR_Z "setup.wheel_slices[%d].profile.mirror_z"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_SMOOTHING_LENGTH \
    "setup.wheel_slices[%d].profile.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE "setup.wheel_slices[%d].profile.file"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_NAME "setup.wheel_slices[%d].profile.file.name"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_TEXT "setup.wheel_slices[%d].profile.file.text"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_UNIT "setup.wheel_slices[%d].profile.file.unit"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_MIRROR_Y "setup.wheel_slices[%d].profile.file.mirror_y"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_MIRROR_Z "setup.wheel_slices[%d].profile.file.mirror_z"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_SHIFT_Y "setup.wheel_slices[%d].profile.file.shift_y" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_SHIFT_Z "setup.wheel_slices[%d].profile.file.shift_z" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_SMOOTHING_LENGTH \
    "setup.wheel_slices[%d].profile.file.smoothing_length" /* mm */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_SMOOTHING_ORDER \
    "setup.wheel_slices[%d].profile.file.smoothing_order"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_SMOOTHING_LAMBDA \
    "setup.wheel_slices[%d].profile.file.smoothing_lambda" /* mm^3 */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_KINKS "setup.wheel_slices[%d].profile.file.kinks"
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_KINKS_ANGLE \
    "setup.wheel_slices[%d].profile.file.kinks.angle" /* rad */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_KINKS_REST \
    "setup.wheel_slices[%d].profile.file.kinks.rest" /* rad */
#define CONTACTD_PATH_SETUP_WHEEL_SLICES_PROFILE_FILE_KINKS_WIDTH \
    "setup.wheel_slices[%d].profile.file.kinks.width" /* mm */
#define CONTACTD_PATH_SETUP_TRACK "setup.track"
#define CONTACTD_PATH_SETUP_TRACK_GAUGE "setup.track.gauge"               /* mm */
#define CONTACTD_PATH_SETUP_TRACK_GAUGE_HEIGHT "setup.track.gauge_height" /* mm */
#define CONTACTD_PATH_SETUP_TRACK_CANT "setup.track.cant"                 /* rad */
#define CONTACTD_PATH_SETUP_TRACK_RAIL_ORIGIN "setup.track.rail_origin"
#define CONTACTD_PATH_SETUP_TRACK_RAIL_ORIGIN_Y "setup.track.rail_origin.y" /* mm */
#define CONTACTD_PATH_SETUP_TRACK_RAIL_ORIGIN_Z "setup.track.rail_origin.z" /* mm */
#define CONTACTD_PATH_SETUP_TRACK_ROLLER_RADIUS "setup.track.roller_radius" /* mm */
#define CONTACTD_PATH_SETUP_TRACK_ROLLER_LEANS "setup.track.roller_leans"
#define CONTACTD_PATH_SETUP_TRACK_SPRINGS "setup.track.springs"
#define CONTACTD_PATH_SETUP_TRACK_SPRINGS_Y "setup.track.springs.y" /* N/mm */
#define CONTACTD_PATH_SETUP_TRACK_SPRINGS_Z "setup.track.springs.z" /* N/mm */
#define CONTACTD_PATH_SETUP_WHEELSET "setup.wheelset"
#define CONTACTD_PATH_SETUP_WHEELSET_FLANGE_BACK_DISTANCE "setup.wheelset.flange_back_distance" /* mm */
#define CONTACTD_PATH_SETUP_WHEELSET_FLANGE_BACK_POSITION "setup.wheelset.flange_back_position" /* mm */
#define CONTACTD_PATH_SETUP_WHEELSET_NOMINAL_RADIUS "setup.wheelset.nominal_radius"             /* mm */
#define CONTACTD_PATH_SETUP_BODIES "setup.bodies"
#define CONTACTD_PATH_SETUP_BODIES_UPPER "setup.bodies.upper"
#define CONTACTD_PATH_SETUP_BODIES_UPPER_G "setup.bodies.upper.G" /* N/mm^2 */
#define CONTACTD_PATH_SETUP_BODIES_UPPER_NU "setup.bodies.upper.nu"
#define CONTACTD_PATH_SETUP_BODIES_UPPER_RIGID "setup.bodies.upper.rigid"
#define CONTACTD_PATH_SETUP_BODIES_LOWER "setup.bodies.lower"
#define CONTACTD_PATH_SETUP_BODIES_LOWER_G "setup.bodies.lower.G" /* N/mm^2 */
#define CONTACTD_PATH_SETUP_BODIES_LOWER_NU "setup.bodies.lower.nu"
#define CONTACTD_PATH_SETUP_BODIES_LOWER_RIGID "setup.bodies.lower.rigid"
#define CONTACTD_PATH_SETUP_MODEL "setup.model"
#define CONTACTD_PATH_SETUP_NORMAL_MODEL "setup.normal_model"
#define CONTACTD_PATH_SETUP_SIMPLIFIED "setup.simplified"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_SLOPE "setup.simplified.slope"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_SLOPE_K0 "setup.simplified.slope.k0"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_SLOPE_ALPHA "setup.simplified.slope.alpha"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_SLOPE_BETA "setup.simplified.slope.beta"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_BOUND "setup.simplified.bound"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_ON_ELEMENTS "setup.simplified.on_elements"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_BLENDED "setup.simplified.blended"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_COEFFICIENTS "setup.simplified.coefficients"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_K_ADHESION "setup.simplified.k_adhesion"
#define CONTACTD_PATH_SETUP_SIMPLIFIED_K_SLIP "setup.simplified.k_slip"
#define CONTACTD_PATH_SETUP_TEMPERATURE "setup.temperature"
#define CONTACTD_PATH_SETUP_TEMPERATURE_UPPER "setup.temperature.upper"
#define CONTACTD_PATH_SETUP_TEMPERATURE_UPPER_BULK_TEMPERATURE "setup.temperature.upper.bulk_temperature" /* degC */
#define CONTACTD_PATH_SETUP_TEMPERATURE_UPPER_CONDUCTIVITY "setup.temperature.upper.conductivity"         /* W/(m K) */
#define CONTACTD_PATH_SETUP_TEMPERATURE_UPPER_HEAT_CAPACITY "setup.temperature.upper.heat_capacity"       /* J/(kg K) */
#define CONTACTD_PATH_SETUP_TEMPERATURE_UPPER_DENSITY "setup.temperature.upper.density"                   /* kg/m^3 */
#define CONTACTD_PATH_SETUP_TEMPERATURE_LOWER "setup.temperature.lower"
#define CONTACTD_PATH_SETUP_TEMPERATURE_LOWER_BULK_TEMPERATURE "setup.temperature.lower.bulk_temperature" /* degC */
#define CONTACTD_PATH_SETUP_TEMPERATURE_LOWER_CONDUCTIVITY "setup.temperature.lower.conductivity"         /* W/(m K) */
#define CONTACTD_PATH_SETUP_TEMPERATURE_LOWER_HEAT_CAPACITY "setup.temperature.lower.heat_capacity"       /* J/(kg K) */
#define CONTACTD_PATH_SETUP_TEMPERATURE_LOWER_DENSITY "setup.temperature.lower.density"                   /* kg/m^3 */
#define CONTACTD_PATH_SETUP_TEMPERATURE_PLASTIC_SHARE "setup.temperature.plastic_share"
#define CONTACTD_PATH_SETUP_WEAR "setup.wear"
#define CONTACTD_PATH_SETUP_WEAR_ENERGY "setup.wear.energy"
#define CONTACTD_PATH_SETUP_WEAR_LAWS "setup.wear.laws"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_NAME "setup.wear.laws[%d].name"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_SOURCE "setup.wear.laws[%d].source"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_BODY "setup.wear.laws[%d].body"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_RANGE "setup.wear.laws[%d].range"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_RANGE_LEAST "setup.wear.laws[%d].range.least"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_RANGE_MOST "setup.wear.laws[%d].range.most"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD "setup.wear.laws[%d].archard"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_HARDNESS "setup.wear.laws[%d].archard.hardness" /* N/mm^2 */
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_MILD "setup.wear.laws[%d].archard.mild"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEVERE "setup.wear.laws[%d].archard.severe"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEVERE_K "setup.wear.laws[%d].archard.severe.k"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEVERE_VELOCITY "setup.wear.laws[%d].archard.severe.velocity"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEVERE_VELOCITY_LEAST "setup.wear.laws[%d].archard.severe.velocity.least"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEVERE_VELOCITY_MOST "setup.wear.laws[%d].archard.severe.velocity.most"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEIZURE "setup.wear.laws[%d].archard.seizure"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEIZURE_K "setup.wear.laws[%d].archard.seizure.k"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ARCHARD_SEIZURE_PRESSURE "setup.wear.laws[%d].archard.seizure.pressure"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ENERGY "setup.wear.laws[%d].energy"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ENERGY_COEFFICIENT "setup.wear.laws[%d].energy.coefficient" /* mm^3/J */
#define CONTACTD_PATH_SETUP_WEAR_LAWS_USFD "setup.wear.laws[%d].usfd"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_USFD_PIECES "setup.wear.laws[%d].usfd.pieces"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_USFD_PIECES_FROM "setup.wear.laws[%d].usfd.pieces[%d].from"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_USFD_PIECES_VALUE "setup.wear.laws[%d].usfd.pieces[%d].value"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_USFD_PIECES_SLOPE "setup.wear.laws[%d].usfd.pieces[%d].slope"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_USFD_DENSITY "setup.wear.laws[%d].usfd.density" /* kg/m^3 */
#define CONTACTD_PATH_SETUP_WEAR_LAWS_BR "setup.wear.laws[%d].br"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_BR_PIECES "setup.wear.laws[%d].br.pieces"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_BR_PIECES_FROM "setup.wear.laws[%d].br.pieces[%d].from"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_BR_PIECES_VALUE "setup.wear.laws[%d].br.pieces[%d].value"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_BR_PIECES_SLOPE "setup.wear.laws[%d].br.pieces[%d].slope"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZOBORY "setup.wear.laws[%d].zobory"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZOBORY_PIECES "setup.wear.laws[%d].zobory.pieces"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZOBORY_PIECES_FROM "setup.wear.laws[%d].zobory.pieces[%d].from"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZOBORY_PIECES_VALUE "setup.wear.laws[%d].zobory.pieces[%d].value"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZOBORY_PIECES_SLOPE "setup.wear.laws[%d].zobory.pieces[%d].slope"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZOBORY_DENSITY "setup.wear.laws[%d].zobory.density" /* kg/m^3 */
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZONES "setup.wear.laws[%d].zones"
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZONES_ANGLE "setup.wear.laws[%d].zones[%d].angle" /* rad */
#define CONTACTD_PATH_SETUP_WEAR_LAWS_ZONES_FACTOR "setup.wear.laws[%d].zones[%d].factor"
#define CONTACTD_PATH_SETUP_FATIGUE "setup.fatigue"
#define CONTACTD_PATH_SETUP_FATIGUE_BODY "setup.fatigue.body"
#define CONTACTD_PATH_SETUP_FATIGUE_STRENGTH "setup.fatigue.strength"
#define CONTACTD_PATH_SETUP_FATIGUE_STRENGTH_NAME "setup.fatigue.strength.name"
#define CONTACTD_PATH_SETUP_FATIGUE_STRENGTH_SOURCE "setup.fatigue.strength.source"
#define CONTACTD_PATH_SETUP_FATIGUE_STRENGTH_SHEAR_YIELD "setup.fatigue.strength.shear_yield" /* N/mm^2 */
#define CONTACTD_PATH_SETUP_FATIGUE_STRENGTH_A_DV "setup.fatigue.strength.a_DV"
#define CONTACTD_PATH_SETUP_FATIGUE_STRENGTH_TAU_E "setup.fatigue.strength.tau_e" /* N/mm^2 */
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES "setup.fatigue.damages"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_NAME "setup.fatigue.damages[%d].name"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_SOURCE "setup.fatigue.damages[%d].source"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_RANGE "setup.fatigue.damages[%d].range"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_RANGE_LEAST "setup.fatigue.damages[%d].range.least"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_RANGE_MOST "setup.fatigue.damages[%d].range.most"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_PIECES "setup.fatigue.damages[%d].pieces"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_PIECES_FROM "setup.fatigue.damages[%d].pieces[%d].from"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_PIECES_VALUE "setup.fatigue.damages[%d].pieces[%d].value"
#define CONTACTD_PATH_SETUP_FATIGUE_DAMAGES_PIECES_SLOPE "setup.fatigue.damages[%d].pieces[%d].slope"
#define CONTACTD_PATH_SETUP_FATIGUE_PASSAGE "setup.fatigue.passage"
#define CONTACTD_PATH_SETUP_FATIGUE_PASSAGE_DEPTHS "setup.fatigue.passage.depths"
#define CONTACTD_PATH_SETUP_FATIGUE_PASSAGE_RESIDUAL "setup.fatigue.passage.residual"
#define CONTACTD_PATH_SETUP_FATIGUE_PASSAGE_RESIDUAL_DEPTH "setup.fatigue.passage.residual[%d].depth" /* mm */
#define CONTACTD_PATH_SETUP_FATIGUE_PASSAGE_RESIDUAL_XX "setup.fatigue.passage.residual[%d].xx"       /* N/mm^2 */
#define CONTACTD_PATH_SETUP_FATIGUE_PASSAGE_RESIDUAL_YY "setup.fatigue.passage.residual[%d].yy"       /* N/mm^2 */
#define CONTACTD_PATH_SETUP_SHEET_FLEXIBILITY "setup.sheet_flexibility"                               /* mm^3/N */
#define CONTACTD_PATH_SETUP_FRICTION "setup.friction"
#define CONTACTD_PATH_SETUP_FRICTION_MU "setup.friction.mu"
#define CONTACTD_PATH_SETUP_FRICTION_MU_ANGLE "setup.friction.mu[%d].angle" /* rad */
#define CONTACTD_PATH_SETUP_FRICTION_MU_MU "setup.friction.mu[%d].mu"
#define CONTACTD_PATH_SETUP_FRICTION_ALONG_PROFILE "setup.friction.along_profile"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC "setup.friction.kinetic"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_LAW "setup.friction.kinetic.law"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_MU "setup.friction.kinetic.mu"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_SLIP_VELOCITY "setup.friction.kinetic.slip_velocity" /* mm/s */
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_START "setup.friction.kinetic.start"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_SECOND "setup.friction.kinetic.second"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_SECOND_FALL "setup.friction.kinetic.second.fall"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_SECOND_SLIP_VELOCITY \
    "setup.friction.kinetic.second.slip_velocity" /* mm/s */
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_MEMORY "setup.friction.kinetic.memory"
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_MEMORY_DISTANCE "setup.friction.kinetic.memory.distance" /* mm */
#define CONTACTD_PATH_SETUP_FRICTION_KINETIC_MEMORY_LEAST_VELOCITY \
    "setup.friction.kinetic.memory.least_velocity" /* mm/s */
#define CONTACTD_PATH_SETUP_FRICTION_LAYER "setup.friction.layer"
#define CONTACTD_PATH_SETUP_FRICTION_LAYER_FLEXIBILITY "setup.friction.layer.flexibility"   /* mm^3/N */
#define CONTACTD_PATH_SETUP_FRICTION_LAYER_YIELD_STRESS "setup.friction.layer.yield_stress" /* N/mm^2 */
#define CONTACTD_PATH_SETUP_FRICTION_LAYER_HARDENING "setup.friction.layer.hardening"       /* N/mm^3 */
#define CONTACTD_PATH_SETUP_FRICTION_LAYER_RESIDUAL "setup.friction.layer.residual"
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE "setup.friction.temperature"
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_CHANGE "setup.friction.temperature.change"
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_REFERENCE "setup.friction.temperature.reference" /* degC */
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_RANGE "setup.friction.temperature.range"         /* K */
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_MEMORY "setup.friction.temperature.memory"
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_MEMORY_DISTANCE "setup.friction.temperature.memory.distance" /* mm */
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_MEMORY_LEAST_VELOCITY \
    "setup.friction.temperature.memory.least_velocity" /* mm/s */
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_BY_ANGLE "setup.friction.temperature_by_angle"
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_BY_ANGLE_ANGLE \
    "setup.friction.temperature_by_angle[%d].angle" /* rad */
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_BY_ANGLE_CHANGE "setup.friction.temperature_by_angle[%d].change"
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_BY_ANGLE_REFERENCE \
    "setup.friction.temperature_by_angle[%d].reference" /* degC */
#define CONTACTD_PATH_SETUP_FRICTION_TEMPERATURE_BY_ANGLE_RANGE "setup.friction.temperature_by_angle[%d].range"
#define CONTACTD_PATH_SETUP_FRICTION_MEMORY "setup.friction.memory"
#define CONTACTD_PATH_SETUP_FRICTION_MEMORY_DISTANCE "setup.friction.memory.distance"             /* mm */
#define CONTACTD_PATH_SETUP_FRICTION_MEMORY_LEAST_VELOCITY "setup.friction.memory.least_velocity" /* mm/s */
#define CONTACTD_PATH_SETUP_DX "setup.dx"                                                         /* mm */
#define CONTACTD_PATH_SETUP_DY "setup.dy"                                                         /* mm */
#define CONTACTD_PATH_SETUP_DQ "setup.dq"                                                         /* mm */
#define CONTACTD_PATH_SETUP_PATCHES "setup.patches"
#define CONTACTD_PATH_SETUP_PATCHES_ANGLE_SEPARATE "setup.patches.angle_separate"       /* rad */
#define CONTACTD_PATH_SETUP_PATCHES_DISTANCE_SEPARATE "setup.patches.distance_separate" /* mm */
#define CONTACTD_PATH_SETUP_PATCHES_DISTANCE_COMBINE "setup.patches.distance_combine"   /* mm */
#define CONTACTD_PATH_SETUP_PATCHES_DISTANCE_TURN "setup.patches.distance_turn"         /* mm */
#define CONTACTD_PATH_SETUP_PATCHES_LOCUS_STEP "setup.patches.locus_step"
#define CONTACTD_PATH_SETUP_PATCHES_SEARCH "setup.patches.search"
#define CONTACTD_PATH_SETUP_PATCHES_HISTORY "setup.patches.history"
#define CONTACTD_PATH_SETUP_PATCHES_MAX_ELEMENTS "setup.patches.max_elements"
#define CONTACTD_PATH_SETUP_RAIL_SPLINE "setup.rail_spline"
#define CONTACTD_PATH_SETUP_WHEEL_SPLINE "setup.wheel_spline"
#define CONTACTD_PATH_SETUP_WHEEL_SURFACE "setup.wheel_surface"
#define CONTACTD_PATH_SETUP_RIGID_SLIP "setup.rigid_slip"
#define CONTACTD_PATH_SETUP_SLOPE_FORCES "setup.slope_forces"
#define CONTACTD_PATH_SETUP_CONFORMAL "setup.conformal"
#define CONTACTD_PATH_SETUP_SETTINGS "setup.settings"
#define CONTACTD_PATH_SETUP_SETTINGS_NORMAL "setup.settings.normal"
#define CONTACTD_PATH_SETUP_SETTINGS_NORMAL_TOLERANCE "setup.settings.normal.tolerance"
#define CONTACTD_PATH_SETUP_SETTINGS_NORMAL_MAX_ITERATIONS "setup.settings.normal.max_iterations"
#define CONTACTD_PATH_SETUP_SETTINGS_TANGENTIAL "setup.settings.tangential"
#define CONTACTD_PATH_SETUP_SETTINGS_TANGENTIAL_TOLERANCE "setup.settings.tangential.tolerance"
#define CONTACTD_PATH_SETUP_SETTINGS_TANGENTIAL_MAX_ITERATIONS "setup.settings.tangential.max_iterations"
#define CONTACTD_PATH_SETUP_SETTINGS_TANGENTIAL_SOLVER "setup.settings.tangential.solver"
#define CONTACTD_PATH_SETUP_SETTINGS_OUTER "setup.settings.outer"
#define CONTACTD_PATH_SETUP_SETTINGS_OUTER_TOLERANCE "setup.settings.outer.tolerance"
#define CONTACTD_PATH_SETUP_SETTINGS_OUTER_MAX_ITERATIONS "setup.settings.outer.max_iterations"
#define CONTACTD_PATH_SETUP_FORCE "setup.force"
#define CONTACTD_PATH_SETUP_FORCE_TOLERANCE "setup.force.tolerance"
#define CONTACTD_PATH_SETUP_FORCE_MAX_ITERATIONS "setup.force.max_iterations"
#define CONTACTD_PATH_SETUP_ACCURACY "setup.accuracy"
#define CONTACTD_PATH_STATE "state"
#define CONTACTD_PATH_STATE_POSITION "state.position"
#define CONTACTD_PATH_STATE_POSITION_Y "state.position.y"         /* mm */
#define CONTACTD_PATH_STATE_POSITION_Z "state.position.z"         /* mm */
#define CONTACTD_PATH_STATE_POSITION_ROLL "state.position.roll"   /* rad */
#define CONTACTD_PATH_STATE_POSITION_YAW "state.position.yaw"     /* rad */
#define CONTACTD_PATH_STATE_POSITION_X "state.position.x"         /* mm */
#define CONTACTD_PATH_STATE_POSITION_PITCH "state.position.pitch" /* rad */
#define CONTACTD_PATH_STATE_VELOCITY "state.velocity"
#define CONTACTD_PATH_STATE_VELOCITY_X "state.velocity.x"         /* mm/s */
#define CONTACTD_PATH_STATE_VELOCITY_Y "state.velocity.y"         /* mm/s */
#define CONTACTD_PATH_STATE_VELOCITY_Z "state.velocity.z"         /* mm/s */
#define CONTACTD_PATH_STATE_VELOCITY_ROLL "state.velocity.roll"   /* rad/s */
#define CONTACTD_PATH_STATE_VELOCITY_YAW "state.velocity.yaw"     /* rad/s */
#define CONTACTD_PATH_STATE_VELOCITY_PITCH "state.velocity.pitch" /* rad/s */
#define CONTACTD_PATH_STATE_WHEEL "state.wheel"
#define CONTACTD_PATH_STATE_WHEEL_X "state.wheel.x"                           /* mm */
#define CONTACTD_PATH_STATE_WHEEL_Y "state.wheel.y"                           /* mm */
#define CONTACTD_PATH_STATE_WHEEL_Z "state.wheel.z"                           /* mm */
#define CONTACTD_PATH_STATE_WHEEL_ROLL "state.wheel.roll"                     /* rad */
#define CONTACTD_PATH_STATE_WHEEL_YAW "state.wheel.yaw"                       /* rad */
#define CONTACTD_PATH_STATE_WHEEL_PITCH "state.wheel.pitch"                   /* rad */
#define CONTACTD_PATH_STATE_WHEEL_X_VELOCITY "state.wheel.x_velocity"         /* mm/s */
#define CONTACTD_PATH_STATE_WHEEL_Y_VELOCITY "state.wheel.y_velocity"         /* mm/s */
#define CONTACTD_PATH_STATE_WHEEL_Z_VELOCITY "state.wheel.z_velocity"         /* mm/s */
#define CONTACTD_PATH_STATE_WHEEL_ROLL_VELOCITY "state.wheel.roll_velocity"   /* rad/s */
#define CONTACTD_PATH_STATE_WHEEL_YAW_VELOCITY "state.wheel.yaw_velocity"     /* rad/s */
#define CONTACTD_PATH_STATE_WHEEL_PITCH_VELOCITY "state.wheel.pitch_velocity" /* rad/s */
#define CONTACTD_PATH_STATE_RAIL "state.rail"
#define CONTACTD_PATH_STATE_RAIL_Y "state.rail.y"                         /* mm */
#define CONTACTD_PATH_STATE_RAIL_Z "state.rail.z"                         /* mm */
#define CONTACTD_PATH_STATE_RAIL_ROLL "state.rail.roll"                   /* rad */
#define CONTACTD_PATH_STATE_RAIL_Y_VELOCITY "state.rail.y_velocity"       /* mm/s */
#define CONTACTD_PATH_STATE_RAIL_Z_VELOCITY "state.rail.z_velocity"       /* mm/s */
#define CONTACTD_PATH_STATE_RAIL_ROLL_VELOCITY "state.rail.roll_velocity" /* rad/s */
#define CONTACTD_PATH_STATE_RAIL_FY "state.rail.Fy"                       /* N */
#define CONTACTD_PATH_STATE_RAIL_FZ "state.rail.Fz"                       /* N */
#define CONTACTD_PATH_STATE_ROLLER_PITCH "state.roller_pitch"             /* rad/s */
#define CONTACTD_PATH_STATE_FZ "state.Fz"                                 /* N */
#define CONTACTD_PATH_STATE_FX "state.Fx"                                 /* N */
#define CONTACTD_PATH_STATE_MOTION "state.motion"
#define CONTACTD_PATH_STATE_TIME_STEP "state.time_step" /* s */
#define CONTACTD_PATH_STATE_DERIVATIVES "state.derivatives"
#define CONTACTD_PATH_STATE_DISPLACEMENTS "state.displacements"

/* --- results of a wheel --- */
#define CONTACTD_PATH_Z "z"                   /* mm */
#define CONTACTD_PATH_PITCH_RATE "pitch_rate" /* rad/s */
#define CONTACTD_PATH_WHEEL_FRAME "wheel_frame"
#define CONTACTD_PATH_WHEEL_FRAME_X "wheel_frame.x"       /* mm */
#define CONTACTD_PATH_WHEEL_FRAME_Y "wheel_frame.y"       /* mm */
#define CONTACTD_PATH_WHEEL_FRAME_Z "wheel_frame.z"       /* mm */
#define CONTACTD_PATH_WHEEL_FRAME_ROLL "wheel_frame.roll" /* rad */
#define CONTACTD_PATH_WHEEL_FRAME_YAW "wheel_frame.yaw"   /* rad */
#define CONTACTD_PATH_RAIL_FRAME "rail_frame"
#define CONTACTD_PATH_RAIL_FRAME_X "rail_frame.x"       /* mm */
#define CONTACTD_PATH_RAIL_FRAME_Y "rail_frame.y"       /* mm */
#define CONTACTD_PATH_RAIL_FRAME_Z "rail_frame.z"       /* mm */
#define CONTACTD_PATH_RAIL_FRAME_ROLL "rail_frame.roll" /* rad */
#define CONTACTD_PATH_RAIL_FRAME_YAW "rail_frame.yaw"   /* rad */
#define CONTACTD_PATH_FORCES_TRACK "forces.track"
#define CONTACTD_PATH_FORCES_TRACK_FX "forces.track.Fx" /* N */
#define CONTACTD_PATH_FORCES_TRACK_FY "forces.track.Fy" /* N */
#define CONTACTD_PATH_FORCES_TRACK_FZ "forces.track.Fz" /* N */
#define CONTACTD_PATH_FORCES_TRACK_MX "forces.track.Mx" /* N mm */
#define CONTACTD_PATH_FORCES_TRACK_MY "forces.track.My" /* N mm */
#define CONTACTD_PATH_FORCES_TRACK_MZ "forces.track.Mz" /* N mm */
#define CONTACTD_PATH_FORCES_RAIL "forces.rail"
#define CONTACTD_PATH_FORCES_RAIL_FX "forces.rail.Fx" /* N */
#define CONTACTD_PATH_FORCES_RAIL_FY "forces.rail.Fy" /* N */
#define CONTACTD_PATH_FORCES_RAIL_FZ "forces.rail.Fz" /* N */
#define CONTACTD_PATH_FORCES_RAIL_MX "forces.rail.Mx" /* N mm */
#define CONTACTD_PATH_FORCES_RAIL_MY "forces.rail.My" /* N mm */
#define CONTACTD_PATH_FORCES_RAIL_MZ "forces.rail.Mz" /* N mm */
#define CONTACTD_PATH_FORCES_WHEELSET "forces.wheelset"
#define CONTACTD_PATH_FORCES_WHEELSET_FX "forces.wheelset.Fx" /* N */
#define CONTACTD_PATH_FORCES_WHEELSET_FY "forces.wheelset.Fy" /* N */
#define CONTACTD_PATH_FORCES_WHEELSET_FZ "forces.wheelset.Fz" /* N */
#define CONTACTD_PATH_FORCES_WHEELSET_MX "forces.wheelset.Mx" /* N mm */
#define CONTACTD_PATH_FORCES_WHEELSET_MY "forces.wheelset.My" /* N mm */
#define CONTACTD_PATH_FORCES_WHEELSET_MZ "forces.wheelset.Mz" /* N mm */
#define CONTACTD_PATH_PATCHES "patches"
#define CONTACTD_PATH_PATCHES_PLACE "patches[%d].place"
#define CONTACTD_PATH_PATCHES_PLACE_REFERENCE "patches[%d].place.reference"
#define CONTACTD_PATH_PATCHES_PLACE_REFERENCE_X "patches[%d].place.reference.x"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REFERENCE_Y "patches[%d].place.reference.y"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REFERENCE_Z "patches[%d].place.reference.z"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REFERENCE_ANGLE "patches[%d].place.reference.angle" /* rad */
#define CONTACTD_PATH_PATCHES_PLACE_ON_RAIL "patches[%d].place.on_rail"
#define CONTACTD_PATH_PATCHES_PLACE_ON_RAIL_ALONG "patches[%d].place.on_rail.along"   /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_ON_RAIL_ACROSS "patches[%d].place.on_rail.across" /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS "patches[%d].place.regions"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_REFERENCE "patches[%d].place.regions[%d].reference"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_REFERENCE_X "patches[%d].place.regions[%d].reference.x"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_REFERENCE_Y "patches[%d].place.regions[%d].reference.y"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_REFERENCE_Z "patches[%d].place.regions[%d].reference.z"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_REFERENCE_ANGLE "patches[%d].place.regions[%d].reference.angle" /* rad */
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_X "patches[%d].place.regions[%d].x"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_X_FROM "patches[%d].place.regions[%d].x.from"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_X_TO "patches[%d].place.regions[%d].x.to"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_Y "patches[%d].place.regions[%d].y"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_Y_FROM "patches[%d].place.regions[%d].y.from"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_Y_TO "patches[%d].place.regions[%d].y.to"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_Z "patches[%d].place.regions[%d].z"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_Z_FROM "patches[%d].place.regions[%d].z.from"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_Z_TO "patches[%d].place.regions[%d].z.to"
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_PENETRATION "patches[%d].place.regions[%d].penetration" /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_REGIONS_SIZE "patches[%d].place.regions[%d].size"               /* mm^4 */
#define CONTACTD_PATH_PATCHES_PLACE_SHARES "patches[%d].place.shares"
#define CONTACTD_PATH_PATCHES_PLACE_GRID "patches[%d].place.grid"
#define CONTACTD_PATH_PATCHES_PLACE_GRID_NX "patches[%d].place.grid.nx"
#define CONTACTD_PATH_PATCHES_PLACE_GRID_NY "patches[%d].place.grid.ny"
#define CONTACTD_PATH_PATCHES_PLACE_GRID_DX "patches[%d].place.grid.dx"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_GRID_DY "patches[%d].place.grid.dy"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_GRID_X0 "patches[%d].place.grid.x0"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_GRID_Y0 "patches[%d].place.grid.y0"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_APPROACH "patches[%d].place.approach"       /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_PENETRATION "patches[%d].place.penetration" /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_CREEPAGES "patches[%d].place.creepages"
#define CONTACTD_PATH_PATCHES_PLACE_CREEPAGES_XI "patches[%d].place.creepages.xi"
#define CONTACTD_PATH_PATCHES_PLACE_CREEPAGES_ETA "patches[%d].place.creepages.eta"
#define CONTACTD_PATH_PATCHES_PLACE_CREEPAGES_PHI "patches[%d].place.creepages.phi"           /* rad/mm */
#define CONTACTD_PATH_PATCHES_PLACE_CREEPAGES_CHI "patches[%d].place.creepages.chi"           /* rad */
#define CONTACTD_PATH_PATCHES_PLACE_CREEPAGES_VELOCITY "patches[%d].place.creepages.velocity" /* mm/s */
#define CONTACTD_PATH_PATCHES_PLACE_RADII "patches[%d].place.radii"
#define CONTACTD_PATH_PATCHES_PLACE_RADII_WHEEL_ALONG "patches[%d].place.radii.wheel_along"   /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_RADII_WHEEL_ACROSS "patches[%d].place.radii.wheel_across" /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_RADII_RAIL_ALONG "patches[%d].place.radii.rail_along"     /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_RADII_RAIL_ACROSS "patches[%d].place.radii.rail_across"   /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_ROWS "patches[%d].place.rows"
#define CONTACTD_PATH_PATCHES_PLACE_ROWS_Y "patches[%d].place.rows[%d].y"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_ROWS_Z "patches[%d].place.rows[%d].z"         /* mm */
#define CONTACTD_PATH_PATCHES_PLACE_ROWS_ANGLE "patches[%d].place.rows[%d].angle" /* rad */
#define CONTACTD_PATH_PATCHES_GAP "patches[%d].gap"
#define CONTACTD_PATH_PATCHES_SOLUTION "patches[%d].solution"
#define CONTACTD_PATH_PATCHES_SOLUTION_APPROACH "patches[%d].solution.approach" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FORCES "patches[%d].solution.forces"
#define CONTACTD_PATH_PATCHES_SOLUTION_FORCES_FN "patches[%d].solution.forces.Fn" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_FORCES_FX "patches[%d].solution.forces.Fx" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_FORCES_FY "patches[%d].solution.forces.Fy" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_FORCES_MZ "patches[%d].solution.forces.Mz" /* N mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_RESULTANT "patches[%d].solution.resultant"
#define CONTACTD_PATH_PATCHES_SOLUTION_RESULTANT_FX "patches[%d].solution.resultant.Fx" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_RESULTANT_FY "patches[%d].solution.resultant.Fy" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_RESULTANT_FZ "patches[%d].solution.resultant.Fz" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_RESULTANT_MX "patches[%d].solution.resultant.Mx" /* N mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_RESULTANT_MY "patches[%d].solution.resultant.My" /* N mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_RESULTANT_MZ "patches[%d].solution.resultant.Mz" /* N mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_PMAX "patches[%d].solution.pmax"                 /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_AREA "patches[%d].solution.area"
#define CONTACTD_PATH_PATCHES_SOLUTION_AREA_CONTACT "patches[%d].solution.area.contact"   /* mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_AREA_ADHESION "patches[%d].solution.area.adhesion" /* mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_AREA_SLIP "patches[%d].solution.area.slip"         /* mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_AREA_FLOW "patches[%d].solution.area.flow"         /* mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_ELEMENTS "patches[%d].solution.elements"
#define CONTACTD_PATH_PATCHES_SOLUTION_ELEMENTS_CONTACT "patches[%d].solution.elements.contact"
#define CONTACTD_PATH_PATCHES_SOLUTION_ELEMENTS_ADHESION "patches[%d].solution.elements.adhesion"
#define CONTACTD_PATH_PATCHES_SOLUTION_ELEMENTS_SLIP "patches[%d].solution.elements.slip"
#define CONTACTD_PATH_PATCHES_SOLUTION_ELEMENTS_FLOW "patches[%d].solution.elements.flow"
#define CONTACTD_PATH_PATCHES_SOLUTION_ELEMENTS_BORDER "patches[%d].solution.elements.border"
#define CONTACTD_PATH_PATCHES_SOLUTION_ELEMENT_DIVISION "patches[%d].solution.element_division"
#define CONTACTD_PATH_PATCHES_SOLUTION_PRESSURE "patches[%d].solution.pressure"
#define CONTACTD_PATH_PATCHES_SOLUTION_TRACTION_X "patches[%d].solution.traction_x"
#define CONTACTD_PATH_PATCHES_SOLUTION_TRACTION_Y "patches[%d].solution.traction_y"
#define CONTACTD_PATH_PATCHES_SOLUTION_SLIP_X "patches[%d].solution.slip_x"
#define CONTACTD_PATH_PATCHES_SOLUTION_SLIP_Y "patches[%d].solution.slip_y"
#define CONTACTD_PATH_PATCHES_SOLUTION_FLOW_X "patches[%d].solution.flow_x"
#define CONTACTD_PATH_PATCHES_SOLUTION_FLOW_Y "patches[%d].solution.flow_y"
#define CONTACTD_PATH_PATCHES_SOLUTION_YIELD_STRESS "patches[%d].solution.yield_stress"
#define CONTACTD_PATH_PATCHES_SOLUTION_FRICTION_COEFFICIENT "patches[%d].solution.friction_coefficient"
#define CONTACTD_PATH_PATCHES_SOLUTION_DISPLACEMENT_X "patches[%d].solution.displacement_x"
#define CONTACTD_PATH_PATCHES_SOLUTION_DISPLACEMENT_Y "patches[%d].solution.displacement_y"
#define CONTACTD_PATH_PATCHES_SOLUTION_DISPLACEMENT_Z "patches[%d].solution.displacement_z"
#define CONTACTD_PATH_PATCHES_SOLUTION_UPPER_TEMPERATURE "patches[%d].solution.upper_temperature"
#define CONTACTD_PATH_PATCHES_SOLUTION_LOWER_TEMPERATURE "patches[%d].solution.lower_temperature"
#define CONTACTD_PATH_PATCHES_SOLUTION_PRESSURE_BY_APPROACH "patches[%d].solution.pressure_by_approach"
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE "patches[%d].solution.temperature"
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_LARGEST "patches[%d].solution.temperature.largest" /* degC */
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_X "patches[%d].solution.temperature.x"             /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_Y "patches[%d].solution.temperature.y"             /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_LARGEST_UPPER \
    "patches[%d].solution.temperature.largest_upper" /* degC */
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_LARGEST_LOWER \
    "patches[%d].solution.temperature.largest_lower"                                            /* degC */
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_RISE "patches[%d].solution.temperature.rise" /* K */
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_HEAT_UPPER "patches[%d].solution.temperature.heat_upper"
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_HEAT_LOWER "patches[%d].solution.temperature.heat_lower"
#define CONTACTD_PATH_PATCHES_SOLUTION_TEMPERATURE_PECLET "patches[%d].solution.temperature.peclet"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR "patches[%d].solution.wear"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_CAPITAL_T_GAMMA "patches[%d].solution.wear.T_gamma" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_CAPITAL_T_GAMMA_WITH_SPIN \
    "patches[%d].solution.wear.T_gamma_with_spin"                                               /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_DISSIPATION "patches[%d].solution.wear.dissipation" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_FACTOR "patches[%d].solution.wear.factor"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LARGEST_PRESSURE_SLIP \
    "patches[%d].solution.wear.largest_pressure_slip" /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LARGEST_DISSIPATION \
    "patches[%d].solution.wear.largest_dissipation" /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LARGEST_SLIDING_VELOCITY \
    "patches[%d].solution.wear.largest_sliding_velocity" /* mm/s */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_ROWS "patches[%d].solution.wear.rows"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_ROWS_Y "patches[%d].solution.wear.rows[%d].y"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_ROWS_Z "patches[%d].solution.wear.rows[%d].z"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_ROWS_ANGLE "patches[%d].solution.wear.rows[%d].angle" /* rad */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_ROWS_DISSIPATION "patches[%d].solution.wear.rows[%d].dissipation"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_ROWS_PRESSURE_SLIP \
    "patches[%d].solution.wear.rows[%d].pressure_slip" /* N/mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_ROWS_DEPTHS "patches[%d].solution.wear.rows[%d].depths"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LAWS "patches[%d].solution.wear.laws"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LAWS_NAME "patches[%d].solution.wear.laws[%d].name"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LAWS_BODY "patches[%d].solution.wear.laws[%d].body"
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LAWS_AREA "patches[%d].solution.wear.laws[%d].area"   /* mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LAWS_DEPTH "patches[%d].solution.wear.laws[%d].depth" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_WEAR_LAWS_ARGUMENT "patches[%d].solution.wear.laws[%d].argument"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE "patches[%d].solution.fatigue"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_BODY "patches[%d].solution.fatigue.body"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_CAPITAL_T_GAMMA "patches[%d].solution.fatigue.T_gamma" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_TRACTION_COEFFICIENT "patches[%d].solution.fatigue.traction_coefficient"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_FORCE_ANGLE "patches[%d].solution.fatigue.force_angle" /* rad */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DRIVEN "patches[%d].solution.fatigue.driven"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_FI_SURF "patches[%d].solution.fatigue.FI_surf"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_FI_SUB "patches[%d].solution.fatigue.FI_sub" /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_LOAD "patches[%d].solution.fatigue.load"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_LIMIT "patches[%d].solution.fatigue.limit"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_SHEAR "patches[%d].solution.fatigue.shear"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_SHEAR_VALUE "patches[%d].solution.fatigue.shear.value" /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_SHEAR_Y "patches[%d].solution.fatigue.shear.y"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_SHEAR_Z "patches[%d].solution.fatigue.shear.z"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_SHEAR_DEPTH "patches[%d].solution.fatigue.shear.depth" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_VON_MISES "patches[%d].solution.fatigue.von_mises"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_VON_MISES_VALUE \
    "patches[%d].solution.fatigue.von_mises.value"                                                    /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_VON_MISES_Y "patches[%d].solution.fatigue.von_mises.y" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_VON_MISES_Z "patches[%d].solution.fatigue.von_mises.z" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_VON_MISES_DEPTH "patches[%d].solution.fatigue.von_mises.depth" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DANG_VAN "patches[%d].solution.fatigue.dang_van"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DANG_VAN_VALUE "patches[%d].solution.fatigue.dang_van.value"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DANG_VAN_Y "patches[%d].solution.fatigue.dang_van.y"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DANG_VAN_Z "patches[%d].solution.fatigue.dang_van.z"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DANG_VAN_DEPTH "patches[%d].solution.fatigue.dang_van.depth" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_UTILISATION "patches[%d].solution.fatigue.utilisation"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DAMAGES "patches[%d].solution.fatigue.damages"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DAMAGES_NAME "patches[%d].solution.fatigue.damages[%d].name"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_DAMAGES_VALUE "patches[%d].solution.fatigue.damages[%d].value"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS "patches[%d].solution.fatigue.rows"
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_Y "patches[%d].solution.fatigue.rows[%d].y"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_Z "patches[%d].solution.fatigue.rows[%d].z"         /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_ANGLE "patches[%d].solution.fatigue.rows[%d].angle" /* rad */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_PRESSURE \
    "patches[%d].solution.fatigue.rows[%d].pressure" /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_TRACTION \
    "patches[%d].solution.fatigue.rows[%d].traction"                                                        /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_FORCE_X "patches[%d].solution.fatigue.rows[%d].force_x" /* N/mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_FORCE_Y "patches[%d].solution.fatigue.rows[%d].force_y" /* N/mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_SHEAR "patches[%d].solution.fatigue.rows[%d].shear"     /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_SHEAR_DEPTH \
    "patches[%d].solution.fatigue.rows[%d].shear_depth" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_DANG_VAN \
    "patches[%d].solution.fatigue.rows[%d].dang_van" /* N/mm^2 */
#define CONTACTD_PATH_PATCHES_SOLUTION_FATIGUE_ROWS_DANG_VAN_DEPTH \
    "patches[%d].solution.fatigue.rows[%d].dang_van_depth" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_ROLLING_RESISTANCE "patches[%d].solution.rolling_resistance"
#define CONTACTD_PATH_PATCHES_SOLUTION_ROLLING_RESISTANCE_FORCE "patches[%d].solution.rolling_resistance.force"
#define CONTACTD_PATH_PATCHES_SOLUTION_ROLLING_RESISTANCE_POWER "patches[%d].solution.rolling_resistance.power"
#define CONTACTD_PATH_PATCHES_SOLUTION_ROLLING_RESISTANCE_CENTRE_OF_PRESSURE \
    "patches[%d].solution.rolling_resistance.centre_of_pressure" /* mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_ROLLING_RESISTANCE_MOMENT "patches[%d].solution.rolling_resistance.moment"
#define CONTACTD_PATH_PATCHES_SOLUTION_ROLLING_RESISTANCE_DEFECT "patches[%d].solution.rolling_resistance.defect"
#define CONTACTD_PATH_PATCHES_SOLUTION_ELASTIC_ENERGY "patches[%d].solution.elastic_energy"     /* N mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FRICTIONAL_WORK "patches[%d].solution.frictional_work"   /* N mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_FRICTIONAL_POWER "patches[%d].solution.frictional_power" /* N mm/s */
#define CONTACTD_PATH_PATCHES_SOLUTION_PLASTIC_WORK "patches[%d].solution.plastic_work"         /* N mm */
#define CONTACTD_PATH_PATCHES_SOLUTION_PLASTIC_POWER "patches[%d].solution.plastic_power"       /* N mm/s */
#define CONTACTD_PATH_PATCHES_SOLUTION_LARGEST_FLOW "patches[%d].solution.largest_flow"
#define CONTACTD_PATH_PATCHES_SOLUTION_UPPER_SPEED "patches[%d].solution.upper_speed" /* mm/s */
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES "patches[%d].solution.derivatives"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX "patches[%d].solution.derivatives.Fx"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_XI "patches[%d].solution.derivatives.Fx.xi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_ETA "patches[%d].solution.derivatives.Fx.eta"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_PHI "patches[%d].solution.derivatives.Fx.phi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_RIGID_SHIFT "patches[%d].solution.derivatives.Fx.rigid_shift"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_RIGID_SHIFT_X "patches[%d].solution.derivatives.Fx.rigid_shift.x"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_RIGID_SHIFT_Y "patches[%d].solution.derivatives.Fx.rigid_shift.y"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_ROTATION "patches[%d].solution.derivatives.Fx.rotation"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_APPROACH "patches[%d].solution.derivatives.Fx.approach"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_FN "patches[%d].solution.derivatives.Fx.Fn"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FX_MU "patches[%d].solution.derivatives.Fx.mu"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY "patches[%d].solution.derivatives.Fy"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_XI "patches[%d].solution.derivatives.Fy.xi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_ETA "patches[%d].solution.derivatives.Fy.eta"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_PHI "patches[%d].solution.derivatives.Fy.phi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_RIGID_SHIFT "patches[%d].solution.derivatives.Fy.rigid_shift"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_RIGID_SHIFT_X "patches[%d].solution.derivatives.Fy.rigid_shift.x"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_RIGID_SHIFT_Y "patches[%d].solution.derivatives.Fy.rigid_shift.y"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_ROTATION "patches[%d].solution.derivatives.Fy.rotation"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_APPROACH "patches[%d].solution.derivatives.Fy.approach"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_FN "patches[%d].solution.derivatives.Fy.Fn"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FY_MU "patches[%d].solution.derivatives.Fy.mu"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ "patches[%d].solution.derivatives.Mz"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_XI "patches[%d].solution.derivatives.Mz.xi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_ETA "patches[%d].solution.derivatives.Mz.eta"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_PHI "patches[%d].solution.derivatives.Mz.phi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_RIGID_SHIFT "patches[%d].solution.derivatives.Mz.rigid_shift"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_RIGID_SHIFT_X "patches[%d].solution.derivatives.Mz.rigid_shift.x"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_RIGID_SHIFT_Y "patches[%d].solution.derivatives.Mz.rigid_shift.y"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_ROTATION "patches[%d].solution.derivatives.Mz.rotation"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_APPROACH "patches[%d].solution.derivatives.Mz.approach"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_FN "patches[%d].solution.derivatives.Mz.Fn"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_MZ_MU "patches[%d].solution.derivatives.Mz.mu"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN "patches[%d].solution.derivatives.Fn"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_XI "patches[%d].solution.derivatives.Fn.xi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_ETA "patches[%d].solution.derivatives.Fn.eta"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_PHI "patches[%d].solution.derivatives.Fn.phi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_RIGID_SHIFT "patches[%d].solution.derivatives.Fn.rigid_shift"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_RIGID_SHIFT_X "patches[%d].solution.derivatives.Fn.rigid_shift.x"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_RIGID_SHIFT_Y "patches[%d].solution.derivatives.Fn.rigid_shift.y"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_ROTATION "patches[%d].solution.derivatives.Fn.rotation"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_APPROACH "patches[%d].solution.derivatives.Fn.approach"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_FN "patches[%d].solution.derivatives.Fn.Fn"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_FN_MU "patches[%d].solution.derivatives.Fn.mu"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH "patches[%d].solution.derivatives.approach"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_XI "patches[%d].solution.derivatives.approach.xi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_ETA "patches[%d].solution.derivatives.approach.eta"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_PHI "patches[%d].solution.derivatives.approach.phi"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_RIGID_SHIFT \
    "patches[%d].solution.derivatives.approach.rigid_shift"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_RIGID_SHIFT_X \
    "patches[%d].solution.derivatives.approach.rigid_shift.x"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_RIGID_SHIFT_Y \
    "patches[%d].solution.derivatives.approach.rigid_shift.y"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_ROTATION \
    "patches[%d].solution.derivatives.approach.rotation"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_APPROACH \
    "patches[%d].solution.derivatives.approach.approach"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_FN "patches[%d].solution.derivatives.approach.Fn"
#define CONTACTD_PATH_PATCHES_SOLUTION_DERIVATIVES_APPROACH_MU "patches[%d].solution.derivatives.approach.mu"
#define CONTACTD_PATH_PATCHES_SOLUTION_WARNINGS "patches[%d].solution.warnings"
#define CONTACTD_PATH_PATCHES_SOLUTION_WARNINGS_AT "patches[%d].solution.warnings[%d]"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE "patches[%d].solution.evidence"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_NORMAL "patches[%d].solution.evidence.normal"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_NORMAL_ITERATIONS "patches[%d].solution.evidence.normal.iterations"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_NORMAL_RESIDUAL "patches[%d].solution.evidence.normal.residual"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_NORMAL_CONVERGED "patches[%d].solution.evidence.normal.converged"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_NORMAL_SECONDS "patches[%d].solution.evidence.normal.seconds" /* s */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_TANGENTIAL "patches[%d].solution.evidence.tangential"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_TANGENTIAL_ITERATIONS \
    "patches[%d].solution.evidence.tangential.iterations"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_TANGENTIAL_RESIDUAL "patches[%d].solution.evidence.tangential.residual"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_TANGENTIAL_CONVERGED \
    "patches[%d].solution.evidence.tangential.converged"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_TANGENTIAL_SECONDS \
    "patches[%d].solution.evidence.tangential.seconds" /* s */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_OUTER "patches[%d].solution.evidence.outer"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_OUTER_ITERATIONS "patches[%d].solution.evidence.outer.iterations"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_OUTER_RESIDUAL "patches[%d].solution.evidence.outer.residual"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_OUTER_CONVERGED "patches[%d].solution.evidence.outer.converged"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_OUTER_SECONDS "patches[%d].solution.evidence.outer.seconds" /* s */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_FORCE "patches[%d].solution.evidence.force"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_FORCE_ITERATIONS "patches[%d].solution.evidence.force.iterations"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_FORCE_RESIDUAL "patches[%d].solution.evidence.force.residual"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_FORCE_CONVERGED "patches[%d].solution.evidence.force.converged"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_FORCE_SECONDS "patches[%d].solution.evidence.force.seconds" /* s */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DISCRETISATION "patches[%d].solution.evidence.discretisation"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DISCRETISATION_ELEMENTS_ACROSS \
    "patches[%d].solution.evidence.discretisation.elements_across"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DISCRETISATION_FORCE_ERROR \
    "patches[%d].solution.evidence.discretisation.force_error"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DISCRETISATION_PMAX_ERROR \
    "patches[%d].solution.evidence.discretisation.pmax_error"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DISCRETISATION_SOURCE \
    "patches[%d].solution.evidence.discretisation.source"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DISCRETISATION_ROLLING_ERROR \
    "patches[%d].solution.evidence.discretisation.rolling_error"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DISCRETISATION_COMPLIANCE_RATIO \
    "patches[%d].solution.evidence.discretisation.compliance_ratio"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DERIVATIVES "patches[%d].solution.evidence.derivatives"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DERIVATIVES_ITERATIONS \
    "patches[%d].solution.evidence.derivatives.iterations"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DERIVATIVES_RESIDUAL \
    "patches[%d].solution.evidence.derivatives.residual"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DERIVATIVES_CONVERGED \
    "patches[%d].solution.evidence.derivatives.converged"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_DERIVATIVES_SECONDS \
    "patches[%d].solution.evidence.derivatives.seconds" /* s */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY "patches[%d].solution.evidence.accuracy"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_COARSE "patches[%d].solution.evidence.accuracy.coarse"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_COARSE_NX "patches[%d].solution.evidence.accuracy.coarse.nx"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_COARSE_NY "patches[%d].solution.evidence.accuracy.coarse.ny"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_COARSE_FX \
    "patches[%d].solution.evidence.accuracy.coarse.Fx" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_COARSE_FY \
    "patches[%d].solution.evidence.accuracy.coarse.Fy" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_COARSE_MZ "patches[%d].solution.evidence.accuracy.coarse.Mz"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_FINE "patches[%d].solution.evidence.accuracy.fine"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_FINE_NX "patches[%d].solution.evidence.accuracy.fine.nx"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_FINE_NY "patches[%d].solution.evidence.accuracy.fine.ny"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_FINE_FX \
    "patches[%d].solution.evidence.accuracy.fine.Fx" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_FINE_FY \
    "patches[%d].solution.evidence.accuracy.fine.Fy" /* N */
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_FINE_MZ "patches[%d].solution.evidence.accuracy.fine.Mz"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_FORCE_ERROR \
    "patches[%d].solution.evidence.accuracy.force_error"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_MOMENT_ERROR \
    "patches[%d].solution.evidence.accuracy.moment_error"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_ACCURACY_CONVERGED "patches[%d].solution.evidence.accuracy.converged"
#define CONTACTD_PATH_PATCHES_SOLUTION_EVIDENCE_TANGENTIAL_SOLVER "patches[%d].solution.evidence.tangential_solver"
#define CONTACTD_PATH_PATCHES_FORCES "patches[%d].forces"
#define CONTACTD_PATH_PATCHES_FORCES_TRACK "patches[%d].forces.track"
#define CONTACTD_PATH_PATCHES_FORCES_TRACK_FX "patches[%d].forces.track.Fx" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_TRACK_FY "patches[%d].forces.track.Fy" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_TRACK_FZ "patches[%d].forces.track.Fz" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_TRACK_MX "patches[%d].forces.track.Mx" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_TRACK_MY "patches[%d].forces.track.My" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_TRACK_MZ "patches[%d].forces.track.Mz" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_RAIL "patches[%d].forces.rail"
#define CONTACTD_PATH_PATCHES_FORCES_RAIL_FX "patches[%d].forces.rail.Fx" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_RAIL_FY "patches[%d].forces.rail.Fy" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_RAIL_FZ "patches[%d].forces.rail.Fz" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_RAIL_MX "patches[%d].forces.rail.Mx" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_RAIL_MY "patches[%d].forces.rail.My" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_RAIL_MZ "patches[%d].forces.rail.Mz" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_WHEELSET "patches[%d].forces.wheelset"
#define CONTACTD_PATH_PATCHES_FORCES_WHEELSET_FX "patches[%d].forces.wheelset.Fx" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_WHEELSET_FY "patches[%d].forces.wheelset.Fy" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_WHEELSET_FZ "patches[%d].forces.wheelset.Fz" /* N */
#define CONTACTD_PATH_PATCHES_FORCES_WHEELSET_MX "patches[%d].forces.wheelset.Mx" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_WHEELSET_MY "patches[%d].forces.wheelset.My" /* N mm */
#define CONTACTD_PATH_PATCHES_FORCES_WHEELSET_MZ "patches[%d].forces.wheelset.Mz" /* N mm */
#define CONTACTD_PATH_CLEARANCE "clearance"                                       /* mm */
#define CONTACTD_PATH_FORCE "force"
#define CONTACTD_PATH_FORCE_ITERATIONS "force.iterations"
#define CONTACTD_PATH_FORCE_RESIDUAL "force.residual"
#define CONTACTD_PATH_FORCE_CONVERGED "force.converged"
#define CONTACTD_PATH_FORCE_SECONDS "force.seconds" /* s */
#define CONTACTD_PATH_PITCH_SEARCH "pitch_search"
#define CONTACTD_PATH_PITCH_SEARCH_ITERATIONS "pitch_search.iterations"
#define CONTACTD_PATH_PITCH_SEARCH_RESIDUAL "pitch_search.residual"
#define CONTACTD_PATH_PITCH_SEARCH_CONVERGED "pitch_search.converged"
#define CONTACTD_PATH_PITCH_SEARCH_SECONDS "pitch_search.seconds" /* s */
#define CONTACTD_PATH_RAIL_DEFLECTION "rail_deflection"
#define CONTACTD_PATH_RAIL_DEFLECTION_Y "rail_deflection.y" /* mm */
#define CONTACTD_PATH_RAIL_DEFLECTION_Z "rail_deflection.z" /* mm */
#define CONTACTD_PATH_RAIL_SEARCH "rail_search"
#define CONTACTD_PATH_RAIL_SEARCH_ITERATIONS "rail_search.iterations"
#define CONTACTD_PATH_RAIL_SEARCH_RESIDUAL "rail_search.residual"
#define CONTACTD_PATH_RAIL_SEARCH_CONVERGED "rail_search.converged"
#define CONTACTD_PATH_RAIL_SEARCH_SECONDS "rail_search.seconds" /* s */
#define CONTACTD_PATH_DERIVATIVES_POSITION "derivatives.position"
#define CONTACTD_PATH_DERIVATIVES_POSITION_Y "derivatives.position.y"
#define CONTACTD_PATH_DERIVATIVES_POSITION_Y_FX "derivatives.position.y.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Y_FY "derivatives.position.y.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Y_FZ "derivatives.position.y.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Y_MX "derivatives.position.y.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Y_MY "derivatives.position.y.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Y_MZ "derivatives.position.y.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Z "derivatives.position.z"
#define CONTACTD_PATH_DERIVATIVES_POSITION_Z_FX "derivatives.position.z.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Z_FY "derivatives.position.z.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Z_FZ "derivatives.position.z.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Z_MX "derivatives.position.z.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Z_MY "derivatives.position.z.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_Z_MZ "derivatives.position.z.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_ROLL "derivatives.position.roll"
#define CONTACTD_PATH_DERIVATIVES_POSITION_ROLL_FX "derivatives.position.roll.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_ROLL_FY "derivatives.position.roll.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_ROLL_FZ "derivatives.position.roll.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_ROLL_MX "derivatives.position.roll.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_ROLL_MY "derivatives.position.roll.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_ROLL_MZ "derivatives.position.roll.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_YAW "derivatives.position.yaw"
#define CONTACTD_PATH_DERIVATIVES_POSITION_YAW_FX "derivatives.position.yaw.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_YAW_FY "derivatives.position.yaw.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_YAW_FZ "derivatives.position.yaw.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_POSITION_YAW_MX "derivatives.position.yaw.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_YAW_MY "derivatives.position.yaw.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_POSITION_YAW_MZ "derivatives.position.yaw.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY "derivatives.velocity"
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_X "derivatives.velocity.x"
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_X_FX "derivatives.velocity.x.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_X_FY "derivatives.velocity.x.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_X_FZ "derivatives.velocity.x.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_X_MX "derivatives.velocity.x.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_X_MY "derivatives.velocity.x.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_X_MZ "derivatives.velocity.x.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Y "derivatives.velocity.y"
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Y_FX "derivatives.velocity.y.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Y_FY "derivatives.velocity.y.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Y_FZ "derivatives.velocity.y.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Y_MX "derivatives.velocity.y.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Y_MY "derivatives.velocity.y.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Y_MZ "derivatives.velocity.y.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Z "derivatives.velocity.z"
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Z_FX "derivatives.velocity.z.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Z_FY "derivatives.velocity.z.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Z_FZ "derivatives.velocity.z.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Z_MX "derivatives.velocity.z.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Z_MY "derivatives.velocity.z.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_Z_MZ "derivatives.velocity.z.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_ROLL "derivatives.velocity.roll"
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_ROLL_FX "derivatives.velocity.roll.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_ROLL_FY "derivatives.velocity.roll.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_ROLL_FZ "derivatives.velocity.roll.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_ROLL_MX "derivatives.velocity.roll.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_ROLL_MY "derivatives.velocity.roll.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_ROLL_MZ "derivatives.velocity.roll.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_YAW "derivatives.velocity.yaw"
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_YAW_FX "derivatives.velocity.yaw.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_YAW_FY "derivatives.velocity.yaw.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_YAW_FZ "derivatives.velocity.yaw.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_YAW_MX "derivatives.velocity.yaw.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_YAW_MY "derivatives.velocity.yaw.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_YAW_MZ "derivatives.velocity.yaw.Mz" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_PITCH "derivatives.velocity.pitch"
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_PITCH_FX "derivatives.velocity.pitch.Fx" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_PITCH_FY "derivatives.velocity.pitch.Fy" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_PITCH_FZ "derivatives.velocity.pitch.Fz" /* N */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_PITCH_MX "derivatives.velocity.pitch.Mx" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_PITCH_MY "derivatives.velocity.pitch.My" /* N mm */
#define CONTACTD_PATH_DERIVATIVES_VELOCITY_PITCH_MZ "derivatives.velocity.pitch.Mz" /* N mm */
#define CONTACTD_PATH_ROLL "roll"                                                   /* rad */
#define CONTACTD_PATH_ROLL_SEARCH "roll_search"
#define CONTACTD_PATH_ROLL_SEARCH_ITERATIONS "roll_search.iterations"
#define CONTACTD_PATH_ROLL_SEARCH_RESIDUAL "roll_search.residual"
#define CONTACTD_PATH_ROLL_SEARCH_CONVERGED "roll_search.converged"
#define CONTACTD_PATH_ROLL_SEARCH_SECONDS "roll_search.seconds" /* s */

/* --- keywords --- */
#define CONTACTD_WORD_BODY_SHAPE_HALF_SPACE "half_space"
#define CONTACTD_WORD_BODY_SHAPE_BLOCK "block"
#define CONTACTD_WORD_BODY_SHAPE_LAYERED "layered"
#define CONTACTD_WORD_BODY_SHAPE_LONGITUDINALLY_UNIFORM "longitudinally_uniform"
#define CONTACTD_WORD_CONFORMAL_OFF "off"
#define CONTACTD_WORD_CONFORMAL_HALF_SPACE "half_space"
#define CONTACTD_WORD_CONFORMAL_ROTATED "rotated"
#define CONTACTD_WORD_CONFORMAL_FEM "fem"
#define CONTACTD_WORD_CONFORMAL_AUTO "auto"
#define CONTACTD_WORD_CONFORMAL_ROTATED_DISPLACEMENTS "rotated_displacements"
#define CONTACTD_WORD_CONTACT_SEARCH_LOCUS "locus"
#define CONTACTD_WORD_CONTACT_SEARCH_MESH "mesh"
#define CONTACTD_WORD_CREEPAGE_COEFFICIENTS_COMPUTED "computed"
#define CONTACTD_WORD_CREEPAGE_COEFFICIENTS_PRINTED "printed"
#define CONTACTD_WORD_DIAGONAL_OUTWARD "outward"
#define CONTACTD_WORD_DIAGONAL_ACROSS "across"
#define CONTACTD_WORD_ERROR_SOURCE_HERTZ "hertz"
#define CONTACTD_WORD_ERROR_SOURCE_ESTIMATE "estimate"
#define CONTACTD_WORD_FAR_BOUNDARY_CLAMPED "clamped"
#define CONTACTD_WORD_FAR_BOUNDARY_HALF_SPACE "half_space"
#define CONTACTD_WORD_IC_SOURCE_ANALYTIC "analytic"
#define CONTACTD_WORD_IC_SOURCE_FEM "fem"
#define CONTACTD_WORD_LOAD_SHAPE_CONSTANT "constant"
#define CONTACTD_WORD_LOAD_SHAPE_BILINEAR "bilinear"
#define CONTACTD_WORD_MESH_HEX "hex"
#define CONTACTD_WORD_MESH_PRISM "prism"
#define CONTACTD_WORD_MESH_ADAPTIVE "adaptive"
#define CONTACTD_WORD_MODEL_FULL "full"
#define CONTACTD_WORD_MODEL_HERTZ "hertz"
#define CONTACTD_WORD_MODEL_FASTSIM "fastsim"
#define CONTACTD_WORD_MODEL_FASTRIP "fastrip"
#define CONTACTD_WORD_MODEL_POLACH "polach"
#define CONTACTD_WORD_NORMAL_MODEL_OF_MODEL "of_model"
#define CONTACTD_WORD_NORMAL_MODEL_KP "kp"
#define CONTACTD_WORD_NORMAL_MODEL_KPEC "kpec"
#define CONTACTD_WORD_NORMAL_MODEL_ANALYN "analyn"
#define CONTACTD_WORD_NORMAL_MODEL_ELLIPTIC "elliptic"
#define CONTACTD_WORD_NORMAL_MODEL_PARABOLIC "parabolic"
#define CONTACTD_WORD_PATCH_HISTORY_OWN "own"
#define CONTACTD_WORD_PATCH_HISTORY_WHOLE "whole"
#define CONTACTD_WORD_RIGID_SLIP_PLANE "plane"
#define CONTACTD_WORD_RIGID_SLIP_SURFACES "surfaces"
#define CONTACTD_WORD_RIGID_SLIP_ELEMENTS "elements"
#define CONTACTD_WORD_ROLLING_STEADY "steady"
#define CONTACTD_WORD_ROLLING_TRANSIENT "transient"
#define CONTACTD_WORD_SAMPLING_FEM "fem"
#define CONTACTD_WORD_SAMPLING_LINEAR "linear"
#define CONTACTD_WORD_SAMPLING_LINEAR_NODES "linear_nodes"
#define CONTACTD_WORD_SIDE_LEFT "left"
#define CONTACTD_WORD_SIDE_RIGHT "right"
#define CONTACTD_WORD_SLICE_SPLINE_SHAPE_PRESERVING "shape_preserving"
#define CONTACTD_WORD_SLICE_SPLINE_CUBIC "cubic"
#define CONTACTD_WORD_SLICE_SPLINE_APPROXIMATING "approximating"
#define CONTACTD_WORD_SLIP_LAW_LINEAR "linear"
#define CONTACTD_WORD_SLIP_LAW_EXPONENTIAL "exponential"
#define CONTACTD_WORD_SLIP_LAW_RATIONAL "rational"
#define CONTACTD_WORD_SLIP_START_ADHESION "adhesion"
#define CONTACTD_WORD_SLIP_START_FULL_SLIP "full_slip"
#define CONTACTD_WORD_SLOPE_FORCES_PRESSURE "pressure"
#define CONTACTD_WORD_SLOPE_FORCES_ALL "all"
#define CONTACTD_WORD_SLOPE_FORCES_NONE "none"
#define CONTACTD_WORD_SOLVER_AUTO "auto"
#define CONTACTD_WORD_SOLVER_AMG_PCG "amg_pcg"
#define CONTACTD_WORD_SOLVER_DIRECT "direct"
#define CONTACTD_WORD_STANDARD_NAME_S1002 "S1002"
#define CONTACTD_WORD_STANDARD_NAME_UIC60 "UIC60"
#define CONTACTD_WORD_STANDARD_NAME_49E5 "49E5"
#define CONTACTD_WORD_STANDARD_NAME_54E1 "54E1"
#define CONTACTD_WORD_STANDARD_NAME_54E3 "54E3"
#define CONTACTD_WORD_STANDARD_NAME_60E1 "60E1"
#define CONTACTD_WORD_STANDARD_NAME_60E2 "60E2"
#define CONTACTD_WORD_STOPPING_CRITERION_RESIDUAL "residual"
#define CONTACTD_WORD_STOPPING_CRITERION_UPDATE "update"
#define CONTACTD_WORD_TANGENTIAL_SOLVER_NEWTON "newton"
#define CONTACTD_WORD_TANGENTIAL_SOLVER_TANGCG "tangcg"
#define CONTACTD_WORD_TRACTION_BOUND_PARABOLIC "parabolic"
#define CONTACTD_WORD_TRACTION_BOUND_ELLIPTIC "elliptic"
#define CONTACTD_WORD_WEAR_ENERGY_SCALED "scaled"
#define CONTACTD_WORD_WEAR_ENERGY_PLAIN "plain"
#define CONTACTD_WORD_WHEEL_RAIL_MOTION_STEADY_ROLLING "steady_rolling"
#define CONTACTD_WORD_WHEEL_RAIL_MOTION_TRANSIENT_ROLLING "transient_rolling"
#define CONTACTD_WORD_WHEEL_RAIL_MOTION_SHIFT "shift"
#define CONTACTD_WORD_WHEEL_SURFACE_EXACT "exact"
#define CONTACTD_WORD_WHEEL_SURFACE_BILINEAR "bilinear"
#define CONTACTD_WORD_WORN_BODY_UPPER "upper"
#define CONTACTD_WORD_WORN_BODY_LOWER "lower"

#endif
