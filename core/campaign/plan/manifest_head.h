// The first line of a campaign's manifest: what all of its runs share.
#pragma once

#include <QJsonObject>
#include <QString>

#include "core/base/result.h"

namespace usar::campaign {

/// Reads the line; its keys are those that `toText` of the manifest writes. Fails if the folder holds no campaign.
Result<QJsonObject> readManifestHead(const QString& folder);

} // namespace usar::campaign
