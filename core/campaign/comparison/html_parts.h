// Parts of a page that a comparison and the report of a single variant share.
#pragma once

#include <functional>

#include <QByteArray>
#include <QStringList>

#include "core/campaign/comparison/course_plots.h"
#include "core/campaign/comparison/failures.h"
#include "core/campaign/comparison/html_page.h"
#include "core/campaign/comparison/report.h"

namespace usar::campaign {

inline constexpr std::size_t most_worst_runs = 10; ///< that a page shows

/// An element with one attribute and words in it.
void writeWith(QXmlStreamWriter& xml, const QString& name, const QXmlStreamAttribute& attribute, const QString& words);

/// A paragraph that says so where a list was cut.
void writeCut(QXmlStreamWriter& xml, std::size_t shown, std::size_t all);

/// The share of seeds that are done by each time; nothing if no run was done. The second variant may have neither name
/// nor runs.
void writeProfile(QXmlStreamWriter& xml, const VariantRuns& baseline, const VariantRuns& candidate);

/// The coverage over time and the map of places of one mission; the second variant may have neither name nor runs.
void writeCourse(QXmlStreamWriter& xml, const QString& mission, const VariantRuns& baseline,
                 const VariantRuns& candidate);

/// A table of runs with how each ended, why, what flies it again, and its map or its path.
void writeRuns(QXmlStreamWriter& xml, const QString& title, const std::vector<const RunFigures*>& runs);

/// Why runs were not done. `variants` names one or two, whose runs are counted.
void writeFailures(QXmlStreamWriter& xml, const std::vector<FailureGroup>& groups, const QStringList& variants);

void writeFacts(QXmlStreamWriter& xml, const ReportFacts& facts);

/// A whole page with its style; `write_main` writes what stands on it.
QByteArray pageOf(const QString& title, const std::function<void(QXmlStreamWriter&)>& write_main);

} // namespace usar::campaign
