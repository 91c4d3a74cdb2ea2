// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"

namespace frictionbeam::parts {

/// Section Catalogue: the user's own tables. Before the parts that name their items.
void declare_catalogue(ParameterReader &in);
void parse_catalogue(const ParameterReader &in, Scene &scene);

/// The component of the catalogue that entry Item names. @throws UserError that lists them
const ComponentItem &component_item(const ParameterReader &in, const Scene &scene);

/// Entry Item of a pipe: it is rigid and has the item's mass. @throws UserError beside Rigid or
/// Mass, or if the route is not as long as the item
void parse_component_of_pipe(const ParameterReader &in, const Scene &scene, Pipe &pipe);

/// Entry Item of a hanger: by name, or to be picked when it is sized.
void parse_item_of_hanger(const ParameterReader &in, const Scene &scene, Hanger &hanger);

} // namespace frictionbeam::parts
