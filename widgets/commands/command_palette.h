// The command palette (Ctrl+K): type a few letters of any command, or of a robot, world or mission,
// and press Return. With the model of its list.
#pragma once

#include <vector>

#include <QAbstractListModel>
#include <QFrame>
#include <QLineEdit>
#include <QListView>

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

class EmptyState;

/// Scores how well `typed` matches `text`; higher is better. Every typed word must occur in the text, where matches at
/// the start of a word count more, or begin a word of `words`, which count less. nullopt: no match. Case is ignored; an
/// empty `typed` matches everything equally.
std::optional<int> matchScore(const QString& typed, const QString& text, const QStringList& words = {});

/// Rows are commands and, once something is typed, the registry's offers; by score, then by registration. Commands that
/// are not possible now come last, and only if something is typed. GUI thread; the registry must outlive the model.
class CommandListModel : public QAbstractListModel {
    Q_OBJECT
public:
    /// ShortcutRole is the shortcut as text, GroupRole the group of the command or offer.
    enum Role { ShortcutRole = Qt::UserRole, GroupRole };

    CommandListModel(const CommandRegistry& registry, QObject* parent = nullptr);

    /// Lists what matches; an empty text also asks for new offers, so call it whenever the palette opens.
    void setFilter(const QString& typed);
    /// Does what the row says; nothing for an invalid index.
    void run(const QModelIndex& index);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    /// One of the two pointers is null.
    struct Row {
        const CommandRegistry::Command* command;
        const PaletteOffer* offer;
    };

    QVariant dataOf(const CommandRegistry::Command& command, int role) const;

    const CommandRegistry& registry_;
    std::vector<PaletteOffer> offers_; ///< of the last empty filter
    std::vector<Row> rows_;
};

/// A popup over its window, not a dialog: Escape or a click elsewhere closes it. Up and Down choose while the text
/// cursor stays in the line. GUI thread; owned by the window.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    /// The registry must outlive the palette. The palette is centered over the window, which owns it.
    CommandPalette(const CommandRegistry& registry, QWidget* window);

public slots:
    /// Clears the line, lists the commands that are possible now, and takes the focus.
    void open();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Lists what matches the text and marks its first row.
    void filter(const QString& typed);
    /// Moves the marked row by `by`, stopping at the ends of the list.
    void choose(int by);
    /// Closes the palette and then runs the marked row, so that it may open something itself.
    void run();

    CommandListModel* model_;
    QLineEdit* line_ = new QLineEdit(this);
    QListView* list_ = new QListView(this);
    EmptyState* nothing_; ///< over the list while no row matches
};

} // namespace usar::widgets
