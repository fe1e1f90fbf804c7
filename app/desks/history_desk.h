// Undo and redo for the whole window, the list of what was edited, and the edits of map layers and spawn card.
#pragma once

#include "app/desks/desk.h"

namespace usar::app {

/// Owned by ViewDesk. GUI thread.
class HistoryDesk : public Desk {
    Q_OBJECT
public:
    explicit HistoryDesk(const DeskContext& context) : Desk(context) {}

    void registerCommands() override;
    void wire() override;
    /// The layers were restored from the settings, which is no edit.
    void keepLayers() { layers_ = views_.layers->saveState(); }

private:
    /// Names the commands after what they would undo and redo.
    void showTexts();
    /// Records the state of the layers if the user has changed it. `subject`: what was edited.
    void recordLayers(const QString& subject, const QString& text);

    QByteArray layers_; ///< the state of the layers at the last edit
};

} // namespace usar::app
