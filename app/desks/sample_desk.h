// Desk for the samples that come with the program: a flight, a scan and a campaign to look at before anything is flown.
#pragma once

#include "app/desks/campaign_desk.h"
#include "app/desks/desk.h"
#include "app/desks/file_desk.h"

namespace usar::app {

/// Opens samples just as a user's own files are opened, and offers them where a view is still empty. GUI thread.
class SampleDesk : public Desk {
    Q_OBJECT
public:
    SampleDesk(const DeskContext& context, FileDesk& files, CampaignDesk& campaigns)
        : Desk(context)
        , files_(files)
        , campaigns_(campaigns) {}

    void registerCommands() override;
    void wire() override;

private:
    /// Adds a command that opens a sample; one that is missing is a notice that names its path.
    void addSample(const char* id, const char* name, const std::function<void(const QString& path)>& open);

    /// Copies the sample into the folder for results, because runs are flown again and reports written in it.
    void openCampaign(const QString& sample);

    FileDesk& files_;
    CampaignDesk& campaigns_;
};

} // namespace usar::app
