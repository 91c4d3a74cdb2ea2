// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/temporary_folder.h"
#include "model/line_model.h"
#include "scene/read_scene.h"

#include <fstream>

/// The line of a parameter file given as text.
struct LineFrom {
  explicit LineFrom(const std::string &text)
      : scene(read(text, laws)), line(scene, laws), model(line.model()) {}

  frictionbeam::LawLibrary laws;
  const frictionbeam::Scene scene;
  const frictionbeam::LineModel line;
  const frictionbeam::Model &model;

private:
  static frictionbeam::Scene read(const std::string &text, frictionbeam::LawLibrary &laws) {
    const frictionbeam::TemporaryFolder folder;
    std::ofstream(folder.path + "/line.prm") << text;
    laws.load_builtin();
    return frictionbeam::read_scene(folder.path + "/line.prm", {}, laws);
  }
};
