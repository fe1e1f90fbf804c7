#include "core/mission/fleet/recording_export.h"

#include <utility>

#include "core/link/across_threads.h"

namespace usar::mission {

RecordingExport::~RecordingExport() {
    stop_.request_stop();
    pool_.waitForDone();
}

void RecordingExport::begin(const QString& recording, const QString& file) {
    ++waiting_;
    pool_.start(HandedOver([this, recording, file, stop = stop_.get_token()] {
        const auto summary = recordingToMcapFile(recording, file, true, stop, [this](Seconds done, Seconds whole) {
            link::post(this, [this, done, whole] { emit progressed(done, whole); });
        });
        link::post(this, [this, summary, file, cancelled = stop.stop_requested()] { end(summary, file, cancelled); });
    }));
}

void RecordingExport::cancel() {
    std::exchange(stop_, std::stop_source()).request_stop();
}

void RecordingExport::end(const Result<McapSummary>& summary, const QString& file, bool cancelled) {
    --waiting_;
    if (summary)
        emit done(file, QString::fromStdString(summary->complaint));
    else
        emit refused(QString::fromStdString(summary.error().text()), cancelled);
}

} // namespace usar::mission
