// Writes the file of a campaign, so that it can be flown by the program and changed by hand.
#pragma once

#include <QByteArray>
#include <QString>

#include "core/base/result.h"
#include "core/campaign/plan/campaign.h"

namespace usar::campaign {

/// Returns JSON that `readCampaign` reads back as the same campaign. Files below `folder`, in which the text will
/// stand, are written with relative paths, so that the folder can be moved.
QByteArray writeCampaign(const Campaign& campaign, const QString& folder);

/// Writes a file completely or not at all, and makes its folder if there is none. An error names path and reason.
Result<void> writeWhole(const QString& path, const QByteArray& text);

} // namespace usar::campaign
