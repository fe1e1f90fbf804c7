// The files that a mission leaves on the disk.
#pragma once

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/mission/scan_record.h"

namespace usar::mission {

/// USAR_Scan on the person's Desktop, or in the home folder where there is no Desktop.
QString defaultResultFolder();

/// Writes <stem>_picture.png (with the thesis's marks), <stem>_height.png (16-bit, metadata inside), <stem>.bil and
/// .hdr (float32, NoData), <stem>.json (summary): each first under a temporary name, then renamed; never over an older
/// scan (the stem gets a number). Returns the files. Called off the GUI thread. An unwritable folder is an error that
/// names it.
Result<QStringList> writeResults(const ScanRecord& record, const QJsonObject& summary, const QString& folder);

} // namespace usar::mission
