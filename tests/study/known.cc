// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study.h"

#include "../check.h"

/// Eleven levels from 0.1 to 0.5: the quantile at p is that of 0.1 + 0.4 p, linearly interpolated.
void check_quantiles() {
  const Study found = study(Options{});
  CHECK(found.exit_status == 0);
  const double probabilities[] = {0.05, 0.5, 0.95};
  for (std::size_t i = 0; i < 3; ++i) {
    const double f = 0.1 + 0.4 * probabilities[i];
    CHECK_NEAR(found.quantile("quantity friction", i), f * (P1 + P2), 1e-9);
    CHECK_NEAR(found.quantile("force slide.1", i), P1 * std::hypot(1., f), 1e-3);
  }
  CHECK_NEAR(found.result("quantity motion").at("largest").get<double>(), (F1 - 0.1 * P1) / k,
             1e-9);
  CHECK_NEAR(found.result("quantity motion").at("least").get<double>(), (F1 - 0.5 * P1) / k, 1e-9);
  CHECK(found.result("quantity motion").at("largest_in_run") == 1);
  CHECK_NEAR(found.effect("quantity friction", "friction").at("rank_correlation").get<double>(), 1.,
             1e-12);
  CHECK_NEAR(found.effect("quantity motion", "friction").at("rank_correlation").get<double>(), -1.,
             1e-12);
}

/// Quantiles of samples come to those of the distribution: a Latin hypercube of n runs has one run
/// in each n-th part, so that they are off by no more than a part.
void check_samples() {
  const Options of_sample = {"Study/Runs = 200", "Vary friction/From = 0.1",
                             "Vary friction/To = 0.5"};
  for (const std::string method : {"latin hypercube", "sobol sequence"}) {
    const Study found = study(of_sample + Options{"Study/Method = " + method});
    CHECK(found.exit_status == 0);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK_NEAR(found.quantile("quantity friction", i),
                 (0.1 + 0.4 * std::vector<double>{0.05, 0.5, 0.95}[i]) * (P1 + P2), 0.02);
  }
  // The median of a normal distribution is its mean, of a log-normal one mean/sqrt(1 + (s/m)^2).
  const Options normal = {"Study/Method = latin hypercube", "Study/Runs = 401",
                          "Vary friction/Mean = 0.3",       "Vary friction/Deviation = 0.06",
                          "Vary friction/From = 0.05",      "Vary friction/To = 0.55"};
  CHECK_NEAR(study(normal + Options{"Vary friction/Distribution = normal"})
                 .quantile("quantity friction", 1),
             0.3 * (P1 + P2), 2e-3);
  CHECK_NEAR(study(normal + Options{"Vary friction/Distribution = log-normal"})
                 .quantile("quantity friction", 1),
             0.3 / std::sqrt(1.04) * (P1 + P2), 2e-3);
}

/// Ranks are those of a list's values, whatever their order and however often they come: what
/// depends on one variable alone has a correlation of 1 with it.
void check_ranks_of_lists() {
  const program::TemporaryFolder into;
  const Study found = study(folder + "/sliders_of_a_list.prm", {}, into.path / "results");
  CHECK(found.exit_status == 0);
  CHECK_NEAR(found.effect("quantity friction", "friction").at("rank_correlation").get<double>(), 1.,
             1e-12);
}

/// friction = f1 P1 + f2 P2 with equal variances of both: shares P1^2 and P2^2 of the sum.
void check_sobol_indices() {
  const Study found =
      study(independent + Options{"Study/Method = sobol indices", "Study/Runs = 256"});
  CHECK(found.json.at("runs") == 256 * 4);
  const std::string variable = "Support slide.";
  for (const auto &[place, share] : {std::make_pair("1", 0.2), std::make_pair("2", 0.8)}) {
    const Json &effect =
        found.effect("quantity friction", variable + place + "/Friction coefficient");
    for (const std::string index : {"first", "total"}) {
      const Json &found_share = effect.at(index);
      CHECK(found_share.at("low").get<double>() <= share &&
            share <= found_share.at("high").get<double>());
      CHECK_NEAR(found_share.at("value").get<double>() - share, 0., 0.03);
    }
  }
  CHECK_NEAR(found.effect("quantity motion", variable + "2/Friction coefficient")
                 .at("total")
                 .at("value")
                 .get<double>(),
             0., 1e-9);
}

/// Effects of a linear result are its slope times the range, all the same.
void check_morris() {
  const Study found = study(independent + Options{"Study/Method = morris", "Study/Runs = 4"});
  CHECK(found.json.at("runs") == 4 * 3);
  for (const auto &[place, P] : {std::make_pair("1", P1), std::make_pair("2", P2)}) {
    const Json &effect = found
                             .effect("quantity friction", std::string("Support slide.") + place +
                                                              "/Friction coefficient")
                             .at("elementary");
    CHECK_NEAR(effect.at("mean").get<double>(), 0.4 * P, 1e-8);
    CHECK_NEAR(effect.at("mean_size").get<double>(), 0.4 * P, 1e-8);
    CHECK_NEAR(effect.at("deviation").get<double>(), 0., 1e-6);
    CHECK(effect.at("n") == 4);
  }
  // Of a distribution with tails the range is from 1 % to 99 %; of a list between its values.
  const program::TemporaryFolder into;
  const Study tails = study(folder + "/sliders_with_tails.prm", {}, into.path / "results");
  const auto mean = [](const Study &of) {
    return of.effect("quantity friction", "friction").at("elementary").at("mean").get<double>();
  };
  CHECK_NEAR(mean(tails), 2. * 0.05 * 2.3263478740408408 * (P1 + P2), 1e-6 * (P1 + P2));
  for (const std::string values : {"0.1, 0.5", "0.1, 0.3, 0.5", "0.5, 0.4, 0.1"}) {
    const program::TemporaryFolder of_list;
    const Study list = study(folder + "/sliders_of_a_list.prm",
                             {"Study/Method = morris", "Vary friction/Values = " + values},
                             of_list.path / "results");
    CHECK_NEAR(mean(list), 0.4 * (P1 + P2), 1e-8 * (P1 + P2));
    CHECK_NEAR(
        list.effect("quantity friction", "friction").at("elementary").at("deviation").get<double>(),
        0., 1e-8 * (P1 + P2));
  }
}

/// What a factor multiplies at a place with a number of its own is that number; a value goes there,
/// too.
void check_places() {
  const auto friction = [](const Options &settings, const char *const which) {
    const program::TemporaryFolder into;
    return study(folder + "/sliders_of_places.prm", settings, into.path / "results")
        .result("quantity friction")
        .at(which)
        .get<double>();
  };
  const Options value = {"Vary friction/Meaning = value", "Vary friction/Values = 0.2, 0.4"};
  const double own = 0.3 * P1 + 0.1 * P2;
  for (const Options &places : {Options{}, independent}) {
    CHECK_NEAR(friction(places, "least"), own, 1e-8);
    CHECK_NEAR(friction(places, "largest"), 2. * own, 1e-8);
    CHECK_NEAR(friction(places + value, "least"), 0.2 * (P1 + P2), 1e-8);
    CHECK_NEAR(friction(places + value, "largest"), 0.4 * (P1 + P2), 1e-8);
  }
  CHECK_NEAR(friction({"Vary friction/Entry = Support slide.1/Friction coefficient"}, "largest"),
             own + 0.3 * P1, 1e-8);
  const program::TemporaryFolder into; // beside one that varies by itself the others do
  CHECK_NEAR(study(folder + "/sliders_of_one_place.prm", {}, into.path / "results")
                 .result("quantity friction")
                 .at("largest")
                 .get<double>(),
             2. * 0.3 * P1 + 3. * 0.1 * P2, 1e-8);
}

/// Numbers of study.json are in the units of the case, as those of the tables.
void check_units() {
  const program::TemporaryFolder into;
  const Study found = study(folder + "/sliders.prm", {"Units = mm N"}, into.path / "results");
  CHECK(found.exit_status == 0);
  CHECK(found.result("quantity motion").at("unit") == "mm");
  const double f = 0.1 + 0.4 * 0.95;
  CHECK_NEAR(found.quantile("force slide.1", 2), P1 * std::hypot(1., f), 1e-3);
}
