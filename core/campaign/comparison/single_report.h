// The reports of a campaign that has one variant: its figures, without any verdict.
#pragma once

#include <QByteArray>
#include <QJsonObject>

#include "core/campaign/comparison/report.h"

namespace usar::campaign {

/// The runs, of which there is at least one, belong to the caller; all are of one variant.
struct SingleReport {
    const std::vector<RunFigures>& runs;
    std::string title; ///< of the campaign
    ReportFacts facts;
};

/// "The campaign has one variant, C++, so there is nothing to compare it with.", then a table of its figures.
QString textReport(const SingleReport& report);
/// A page as that of a comparison, without what needs two variants.
QByteArray htmlReport(const SingleReport& report);
/// `title`, `variant`, `exit_code` (0), `runs`, `done`, `note`; `metrics`, a list of objects with `key`, `unit`,
/// `runs`, `quarter`, `median`, `three_quarters`; and `facts`, an object of texts.
QJsonObject jsonReport(const SingleReport& report);

} // namespace usar::campaign
