// A comparison as JSON, for programs.
#pragma once

#include <QJsonObject>

#include "core/campaign/comparison/report.h"

namespace usar::campaign {

/// `title`, `baseline`, `candidate`, `overall` (a word), `exit_code`, `more_seeds`, `confidence`, `pairs`,
/// `single_runs`, `pairs_not_counted`, `repeated_runs`, `missions`; `success` with `baseline` and `candidate`
/// (`successes`, `trials`, `rate`, `low`, `high`), `difference`, `low`, `high`, `p`, `holm_p`, `verdict`, `not_worse`,
/// `more_seeds` and `differing` (`mission`, `pair`, `seed`, `baseline`, `candidate`: words of outcomes); `metrics`, a
/// list of objects with `key`, `unit`, `lower_is_better`, `estimator`, `pairs`, `left_out`, `baseline_unfinished`,
/// `candidate_unfinished`, `limit_assumed` (a number of runs), `baseline_restricted_mean`, `candidate_restricted_mean`,
/// `baseline_median`, `candidate_median`, `median_difference`, `difference`, `low`, `high`,
/// `margin`, `p`, `holm_p`, `correlation`, `variance_ratio`, `ratio`, `improved`, `verdict`, `not_worse`, `more_seeds`;
/// and `facts`, an object of texts. What is not known or not finite is null.
QJsonObject jsonReport(const Report& report);

/// Returns the report of a single candidate. Several give an object with `title`, `baseline`, `exit_code`, `facts`, and
/// `comparisons`, a list of reports without facts.
QJsonObject jsonReport(const CampaignReport& report);

} // namespace usar::campaign
