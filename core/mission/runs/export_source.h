// The files from which a map can be exported afterwards: those of a result, or a recording.
#pragma once

#include <string>

#include <QString>

#include "core/base/result.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// A map that was read back, and how the files that are made of it are called.
struct ExportSource {
    ScanRecord record; ///< has only rasters if it comes from a result, and also scans if from a recording
    QString folder;    ///< where the source is
    QString stem;
    std::string missing; ///< sentences: which parts of a recording the map lacks; empty: none
};

/// Reads a result, of which `path` is the summary (.json), the raw heights (.bil) or their header (.hdr), or plays a
/// recording (.usarrec), which takes a second for an hour of flight; `with_scans`: also its scans. An error names the
/// file. Not for the GUI thread.
Result<ExportSource> openExportSource(const QString& path, bool with_scans);

} // namespace usar::mission
