#include "widgets/commands/shortcut_sheet.h"

#include <algorithm>
#include <utility>

#include <QLabel>
#include <QObject>
#include <QScrollArea>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

/// A heading, and below it pairs of keys or a gesture and their effect.
struct Group {
    QString name;
    QList<std::pair<QString, QString>> lines;
};

QList<Group> groupsOf(const CommandRegistry& registry) {
    QList<Group> groups;
    for (const auto& command : registry.commands()) {
        if (command->spec.shortcuts.isEmpty())
            continue;
        QStringList keys;
        for (const QKeySequence& sequence : command->spec.shortcuts)
            keys << sequence.toString(QKeySequence::NativeText);
        if (const QString key = command->spec.twice.toString(QKeySequence::NativeText); !key.isEmpty())
            keys << QStringLiteral("%1 %1").arg(key);
        auto group = std::ranges::find(groups, command->spec.group, &Group::name);
        if (group == groups.end())
            group = groups.insert(groups.end(), Group{command->spec.group, {}});
        group->lines.emplaceBack(keys.join(QStringLiteral("  ")), command->spec.text);
    }
    return groups;
}

QWidget* groupWidget(const Group& group) {
    auto* box = new QWidget;
    auto* grid = gridOf(box, {0, 0, gap::large, gap::medium}, gap::medium, gap::tiny);
    auto* title = new QLabel(group.name);
    title->setProperty("role", "title");
    grid->addWidget(title, 0, 0, 1, 2);
    int row = 1;
    for (const auto& [keys, effect] : group.lines) {
        grid->addWidget(mutedLabel(keys), row, 0);
        grid->addWidget(new QLabel(effect), row, 1);
        ++row;
    }
    grid->setColumnMinimumWidth(0, 120);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(row, 1);
    return box;
}

QList<std::pair<QString, QString>> gestures() {
    return {{QObject::tr("Double-click a start pose"), QObject::tr("Spawn a robot there")},
            {QObject::tr("Click a start pose"), QObject::tr("Choose class, name and behavior first")},
            {QObject::tr("Drag with the area tool"), QObject::tr("Draw the mission area; its handles change it")},
            {QObject::tr("Wheel"), QObject::tr("Zoom at the cursor")},
            {QObject::tr("Arrow keys, drag"), QObject::tr("Pan the map")},
            {QObject::tr("W S, A D, Q E, R F held while you drive"),
             QObject::tr("Forward and back, round, sideways, up and down; Shift slower, Space stops")},
            {QObject::tr("Drag the camera's picture, wheel on it"), QObject::tr("Turn the camera, zoom it")},
            {QObject::tr("Double-click a sensor value"), QObject::tr("Plot it")},
            {QObject::tr("Press an object in the palette, click on the map"), QObject::tr("Put it into the world")},
            {QObject::tr("Drag an object"), QObject::tr("Move it")}};
}

} // namespace

QDialog* makeShortcutSheet(const CommandRegistry& registry, QWidget* window) {
    auto* dialog = new QDialog(window);
    dialog->setWindowTitle(QObject::tr("Keys and gestures"));
    dialog->setAccessibleName(dialog->windowTitle());
    QList<Group> groups = groupsOf(registry);
    groups.append({QObject::tr("Mouse"), gestures()});
    auto* sheet = new QWidget;
    auto* grid = new QGridLayout(sheet);
    grid->setContentsMargins(gap::large, gap::large, gap::large, gap::large);
    for (int i = 0; i < groups.size(); ++i)
        grid->addWidget(groupWidget(groups[i]), i / 2, i % 2);
    grid->setRowStretch(grid->rowCount(), 1);
    auto* scroll = new QScrollArea(dialog);
    scroll->setWidget(sheet);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    laidOut(new QVBoxLayout(dialog), {}, 0, {scroll});
    constexpr int scroll_bar_px = 24;
    // Wide enough to never need horizontal scrolling.
    dialog->resize(std::max(820, sheet->sizeHint().width() + scroll_bar_px), 520);
    return dialog;
}

} // namespace usar::widgets
