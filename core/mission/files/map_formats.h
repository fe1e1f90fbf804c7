// The formats into which a map can be exported, and their files.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/mission/files/file_set.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// A format for other programs. headless.md tells its units and axes.
struct MapFormat {
    const char* id;    ///< what it is called on the command line, and how its files end
    const char* title; ///< for people
    const char* use;   ///< what is in it and who reads it, as the help says
    /// Writes one raster of heights, which is not empty; null for a format of points.
    bool (*write_heights)(const mapping::Raster& raster, const mapping::ByteSink& sink);
    /// Writes the points that these scans have hit; null for a format of heights.
    bool (*write_points)(std::span<const mapping::KeptScan> scans, const mapping::ByteSink& sink);
};

/// All of them, in the order in which they are offered.
std::span<const MapFormat> mapFormats();

/// Formats that somebody wants; they point into `mapFormats`.
using FormatList = std::vector<const MapFormat*>;

/// Reads "tif,asc"; fails on an unknown format or an empty list, and names those that exist. A format that is named
/// twice is wanted once. `option`: what is before the text on the command line, for the error.
Result<FormatList> readFormatList(const QString& text, const QString& option);
/// True if one of them is a format of points, for which the record must have the scans.
bool needPoints(const FormatList& formats);
/// The formats of these that are made of heights.
FormatList withoutPoints(const FormatList& formats);
/// Fails if one of them needs points and the record does not have the scans.
Result<void> checkPoints(const FormatList& formats, const ScanRecord& record);
/// A sentence about each, for the help.
QStringList formatNotes();

/// Writes the record in each of these formats: `<stem>.tif` and so on, and _far1.tif for parts of the map that are too
/// far away to be in one raster with the rest. The record must have what checkPoints asks for. Does nothing after an
/// error of `files`, and skips what is there already.
void writeFormats(FileSet& files, const FormatList& formats, const ScanRecord& record);

/// Writes only these formats, into files named as by `writeResults` or, if `stem` is not empty, by it. Fails, before
/// anything is written, where one of the files exists already, for a record without heights, and as checkPoints does.
/// Not for the GUI thread.
Result<QStringList> exportMap(const ScanRecord& record, const FormatList& formats, const QString& folder,
                              const QString& stem = {}, const std::stop_token& stop = {});

} // namespace usar::mission
