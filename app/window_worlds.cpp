// The worlds of the embedded simulator, as commands.
#include <algorithm>

#include <QDir>
#include <QFileDialog>
#include <QMenu>

#include "app/locations.h"
#include "app/main_window.h"

namespace usar::app {

namespace {

/// "point_lookout" as a menu says it: "Point lookout".
QString titleOf(QString name) {
    name.replace('_', ' ');
    return name.left(1).toUpper() + name.mid(1);
}

} // namespace

void MainWindow::registerWorldCommands() {
    const auto nothing_runs = [this] {
        return std::ranges::none_of(control_.robots(), [](const Robot* robot) { return robot->running(); });
    };
    for (const QString& name : worldNames())
        commands_.add(
            {"world." + name,
             titleOf(name),
             tr("World"),
             tr("Starts the embedded simulator anew in this world; robots there end"),
             "",
             {}},
            [this, name](bool) { chooseWorld(name); }, nothing_runs);
    commands_.add(
        {"world.folder",
         tr("World from a folder…"),
         tr("World"),
         tr("A folder with world.sdf, height.png and plants.csv; see resources/worlds/README.md"),
         "",
         {}},
        [this](bool) {
            const QString folder = QFileDialog::getExistingDirectory(this, tr("World from a folder"), QDir::homePath());
            if (!folder.isEmpty())
                chooseWorld(folder);
        },
        nothing_runs);
}

void MainWindow::fillWorldMenu(QMenu* menu) {
    QStringList ids;
    for (const QString& name : worldNames())
        ids << "world." + name;
    commands_.fill(menu, ids + QStringList{"-", "world.folder"});
}

} // namespace usar::app
