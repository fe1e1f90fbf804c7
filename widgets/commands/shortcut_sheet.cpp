#include "widgets/commands/shortcut_sheet.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QObject>
#include <QRegularExpression>
#include <QScreen>
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

/// The text without the number at its end: "Select robot " of "Select robot 1".
QString stemOf(const QString& text) {
    static const QRegularExpression number("\\d+$");
    return text.left(text.size() - number.match(text).capturedLength());
}

/// Adds a line; one that differs from the last line by the number of key and effect only widens that line: "1 – 9".
void append(Group& group, const QString& keys, const QString& effect) {
    if (!group.lines.isEmpty()) {
        auto& [last_keys, last_effect] = group.lines.back();
        const QString stem = stemOf(effect);
        const QString first = last_effect.mid(stem.size()).section(u' ', 0, 0);
        if (stem != effect && last_effect.startsWith(stem) && stemOf(keys) != keys) {
            last_effect = stem + first + QStringLiteral(" – ") + effect.mid(stem.size());
            last_keys = last_keys.section(u' ', 0, 0) + QStringLiteral(" – ") + keys;
            return;
        }
    }
    group.lines.emplaceBack(keys, effect);
}

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
        append(*group, keys.join(QStringLiteral("  ")), command->spec.text);
    }
    return groups;
}

QWidget* groupWidget(const Group& group) {
    auto* box = new QWidget;
    auto* grid = gridOf(box, {0, 0, gap::large, gap::small}, gap::medium, 0);
    auto* title = new QLabel(group.name);
    title->setProperty("role", "title");
    grid->addWidget(title, 0, 0, 1, 2);
    int row = 1;
    for (const auto& [keys, effect] : group.lines) {
        grid->addWidget(mutedLabel(keys), row, 0);
        grid->addWidget(new QLabel(effect), row, 1);
        ++row;
    }
    grid->setColumnMinimumWidth(0, 90);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(row, 1);
    return box;
}

QList<std::pair<QString, QString>> gestures() {
    return {{QObject::tr("Double-click a start pose"), QObject::tr("Spawn a robot there")},
            {QObject::tr("Click a start pose"), QObject::tr("Choose class, name, behavior")},
            {QObject::tr("N  Shift+N"), QObject::tr("Next, previous start pose")},
            {QObject::tr("Drag with the area tool"), QObject::tr("Draw the mission area")},
            {QObject::tr("Wheel"), QObject::tr("Zoom at the cursor")},
            {QObject::tr("Arrow keys, drag"), QObject::tr("Pan the map")},
            {QObject::tr("W S  A D, driving"), QObject::tr("Forward and back, turn")},
            {QObject::tr("Q E  R F, driving"), QObject::tr("Sideways, up and down")},
            {QObject::tr("Shift  Space, driving"), QObject::tr("Slower, stop")},
            {QObject::tr("Drag, wheel on the camera"), QObject::tr("Turn it, zoom it")},
            {QObject::tr("Double-click a sensor value"), QObject::tr("Plot it")},
            {QObject::tr("Click an object, then the map"), QObject::tr("Put it into the world")},
            {QObject::tr("Drag an object"), QObject::tr("Move it")}};
}

/// Fills columns from top to bottom, each up to its share of the whole height, so that they are about equally high.
QWidget* inColumns(const QList<QWidget*>& boxes, int columns) {
    auto* const sheet = new QWidget;
    auto* const row = new QHBoxLayout(sheet);
    row->setContentsMargins(gap::large, gap::large, gap::large, gap::large);
    row->setSpacing(0);
    const int whole_px = std::accumulate(boxes.begin(), boxes.end(), 0, [](int sum_px, const QWidget* box) {
        return sum_px + box->sizeHint().height();
    });
    int used_px = 0;
    int filled = 0;
    auto* column = new QVBoxLayout;
    row->addLayout(column);
    for (QWidget* const box : boxes) {
        const int half_px = box->sizeHint().height() / 2;
        if (filled + 1 < columns && (used_px + half_px) * columns > whole_px * (filled + 1)) {
            column->addStretch(1);
            row->addLayout(column = new QVBoxLayout);
            ++filled;
        }
        column->addWidget(box);
        used_px += 2 * half_px;
    }
    column->addStretch(1);
    return sheet;
}

} // namespace

QDialog* makeShortcutSheet(const CommandRegistry& registry, QWidget* window) {
    auto* dialog = new QDialog(window);
    dialog->setWindowTitle(QObject::tr("Keys and gestures"));
    dialog->setAccessibleName(dialog->windowTitle());
    QList<Group> groups = groupsOf(registry);
    groups.append({QObject::tr("Mouse and held keys"), gestures()});
    QList<QWidget*> boxes;
    int widest_px = 1;
    for (const Group& group : groups) {
        boxes << groupWidget(group);
        widest_px = std::max(widest_px, boxes.back()->sizeHint().width());
    }
    constexpr int scroll_bar_px = 24;
    const QSize room = window->screen()->availableSize() - QSize(2 * gap::large + scroll_bar_px, 3 * gap::large);
    QWidget* const sheet = inColumns(boxes, std::clamp(room.width() / widest_px, 1, 4));
    auto* scroll = new QScrollArea(dialog);
    scroll->setWidget(sheet);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    laidOut(new QVBoxLayout(dialog), {}, 0, {scroll});
    // Wide enough to never need horizontal scrolling.
    dialog->resize(sheet->sizeHint().width() + scroll_bar_px, std::min(sheet->sizeHint().height(), room.height()));
    return dialog;
}

} // namespace usar::widgets
