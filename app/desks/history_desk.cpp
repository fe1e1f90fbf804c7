#include "app/desks/history_desk.h"

#include <utility>

namespace usar::app {

void HistoryDesk::registerCommands() {
    mission::EditHistory* const history = &control_.history();
    add(
        "edit.undo", [history] { return history->canUndo(); }, [history] { history->undo(); });
    add(
        "edit.redo", [history] { return history->canRedo(); }, [history] { history->redo(); });
}

void HistoryDesk::wire() {
    mission::EditHistory* const history = &control_.history();
    views_.history->setHistory(history->stack(), [history](int row) { return history->reasonOf(row); });
    connect(history, &mission::EditHistory::changed, this, &HistoryDesk::showTexts);
    connect(&commands_, &widgets::CommandRegistry::sent, this, [this, history](const widgets::CommandSpec& spec) {
        const bool about_all = spec.id.endsWith("_all") || spec.group == widgets::commandSpec("world.go").group;
        history->note(robot() && !about_all ? tr("%1 (%2)").arg(spec.text, nameOf(*robot())) : spec.text);
    });
    connect(views_.layers, &widgets::LayersPanel::layerChanged, this, [this](widgets::MapLayer layer) {
        recordLayers(widgets::layerName(layer), tr("change layer %1").arg(widgets::layerName(layer)));
    });
    connect(views_.layers->heightControls(), &widgets::HeightControls::lookChanged, this,
            [this] { recordLayers("heights", tr("change colors of heights")); });
    auto* const card = views_.spawn_card;
    connect(card, &widgets::SpawnCard::choiceEdited, this,
            [history, card](const widgets::SpawnChoice& before, const widgets::SpawnChoice& after) {
                history->add(mission::valueEdit<widgets::SpawnChoice>(
                    "spawn", tr("change robot to spawn"), before, after,
                    [card](const widgets::SpawnChoice& choice) { card->setChoice(choice); }));
            });
    showTexts();
}

void HistoryDesk::showTexts() {
    const mission::EditHistory& history = control_.history();
    action("edit.undo")->setText(tr("Undo %1").arg(history.undoText()).trimmed());
    action("edit.redo")->setText(tr("Redo %1").arg(history.redoText()).trimmed());
    action("edit.undo")->setIconText(tr("Undo"));
    views_.history->refresh();
    commands_.refresh();
}

void HistoryDesk::recordLayers(const QString& subject, const QString& text) {
    const QByteArray before = std::exchange(layers_, views_.layers->saveState());
    control_.history().add(
        mission::valueEdit<QByteArray>("layers/" + subject, text, before, layers_,
                                       [this](const QByteArray& state) { views_.layers->restoreState(state); }));
}

} // namespace usar::app
