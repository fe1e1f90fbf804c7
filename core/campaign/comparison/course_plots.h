// Drawings of how runs went: coverage over time, and where they flew, collided and gave goals up.
#pragma once

#include <QXmlStreamWriter>

#include "core/campaign/comparison/run_figures.h"

namespace usar::campaign {

/// Some runs of one variant.
struct VariantRuns {
    QString name;
    std::vector<const RunFigures*> runs;
};

/// A variant without a name is not drawn here. The median of each variant's coverage over time, and a band from the
/// tenth to the ninetieth percentile. Draws nothing if no run tells its coverage.
void drawCoverage(QXmlStreamWriter& xml, const VariantRuns& baseline, const VariantRuns& candidate);

/// True if a run of the two collided or gave a goal up, and says where.
bool havePlaces(const VariantRuns& baseline, const VariantRuns& candidate);
/// A map of the places where runs collided and gave goals up, x to the right and y up.
void drawPlaces(QXmlStreamWriter& xml, const VariantRuns& baseline, const VariantRuns& candidate);

/// The picture of its map, made small; false, and nothing is drawn, if none was kept or the file is gone.
bool drawMap(QXmlStreamWriter& xml, const RunFigures& run);
/// A small map of one run: its path with its beginning and end, and the same places. Draws nothing without a path.
void drawCourse(QXmlStreamWriter& xml, const RunFigures& run);

} // namespace usar::campaign
