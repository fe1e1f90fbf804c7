#include "widgets/models/campaign/campaign_progress.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/base/time_range.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

QString progressText(const CampaignProgress& progress) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("CampaignProgress", text); };
    if (progress.state == CampaignState::Closed)
        return {};
    QStringList parts;
    const bool is_counting = progress.state == CampaignState::Running || progress.state == CampaignState::Stopping;
    parts << (progress.runs > 0 ? tr("%1 of %2 runs").arg(progress.done).arg(progress.runs)
              : is_counting     ? tr("counting the runs…")
                                : tr("no runs"));
    if (progress.failures > 0)
        parts << tr("%1 not done").arg(progress.failures);
    if (progress.state == CampaignState::Running && progress.rate_hz > 0.0) {
        const int left = progress.runs - progress.done;
        parts << tr("%1 runs/s").arg(figure(progress.rate_hz, progress.rate_hz < 10.0 ? 1 : 0));
        parts << tr("%1 left").arg(QString::fromStdString(countdownText(Seconds{left / progress.rate_hz})));
    }
    return parts.join(QStringLiteral(" · "));
}

QString stateWord(CampaignState state) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("CampaignProgress", text); };
    switch (state) {
    case CampaignState::Closed:
        break;
    case CampaignState::Running:
        return tr("flying");
    case CampaignState::Stopping:
        return tr("stopping");
    case CampaignState::Stopped:
        return tr("stopped");
    case CampaignState::Complete:
        return tr("complete");
    }
    return {};
}

} // namespace usar::widgets
