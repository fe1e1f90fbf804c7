// Input for raw commands: completion from the grammar, history, and error messages with their column.
#pragma once

#include <optional>

#include <QCompleter>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStringList>
#include <QTimer>
#include <QWidget>

#include "core/base/diagnostics.h"

namespace usar::widgets {

/// A value. A line that is sent again moves to the end; beyond `limit` lines the oldest is removed.
class LineHistory {
public:
    static constexpr qsizetype limit = 200;

    const QStringList& lines() const { return lines_; }
    /// Keeps the newest `limit` lines and ends the walk.
    void setLines(const QStringList& lines);
    /// Appends a sent line and ends the walk.
    void add(const QString& line);

    /// Returns the next older line that contains `typed`, ignoring case; nullopt at the oldest. The first call begins a
    /// walk and remembers `typed`.
    std::optional<QString> older(const QString& typed);
    /// Steps back toward the typed text, which is returned last; nullopt if no walk is in progress.
    std::optional<QString> newer();
    /// The next older() begins a new walk.
    void endWalk() { at_.reset(); }

private:
    /// Moves the walk by `step` (1 or -1) to the next line that contains the typed text; returns false if there is
    /// none.
    bool walk(qsizetype step);

    QStringList lines_;
    QString typed_;
    std::optional<qsizetype> at_; ///< index of the line that the walk is at
};

/// Fixed-pitch font. The owner decides by an event filter whether Tab completes or moves the focus. GUI thread.
class CommandLine : public QLineEdit {
    Q_OBJECT
public:
    explicit CommandLine(QWidget* parent = nullptr);

    /// Underlines these places. Offsets are bytes of the UTF-8 text; each wave reaches to the end of its word.
    void setDiagnostics(const Diagnostics& diagnostics);
    const Diagnostics& diagnostics() const { return diagnostics_; }
    /// The cursor's position in bytes of the UTF-8 text.
    std::size_t cursorByte() const { return static_cast<std::size_t>(text().left(cursorPosition()).toUtf8().size()); }
    /// Position, in bytes, after the last byte of the word that begins at `offset`.
    std::size_t wordEnd(std::size_t offset) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Diagnostics diagnostics_;
};

/// Enter sends the line. A line with an error is sent only by a second Enter; a warning (such as an unknown word) does
/// not prevent sending. Tab accepts a completion; Up and Down walk through the lines of the history that contain the
/// typed text. GUI thread.
class CommandBox : public QWidget {
    Q_OBJECT
public:
    explicit CommandBox(QWidget* parent = nullptr);

    /// Name of the robot that gets the line ("R1"; empty: no connection), and the reason why nothing can be sent; an
    /// empty `refusal` means that sending is possible.
    void setTarget(const QString& name, const QString& refusal);
    /// Sent lines, oldest first.
    QStringList history() const { return history_.lines(); }
    void setHistory(const QStringList& lines) { history_.setLines(lines); }
    /// Shows a sentence under the line until the text changes.
    void complain(Severity severity, const QString& sentence);
    /// The line edit; owned by the box.
    CommandLine* line() const { return line_; }
    /// The sentence shown under the line; empty if there is none.
    QString complaint() const { return complaint_->isHidden() ? QString() : complaint_->text(); }
    /// Offers the completions that fit at the cursor; owned by the box.
    const QCompleter* completer() const { return completer_; }
    /// Opens the list of everything that may follow at the cursor.
    void openCompletions();

signals:
    /// The line to send, trimmed and without a line end.
    void sendRequested(const QString& line);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpCompleter();
    /// The text was edited: ends the walk through the history and opens the completions.
    void takeEdit();
    /// Handles Enter, Tab, the arrow keys and Ctrl+Space; returns true if the key was used.
    bool takeKey(int key, Qt::KeyboardModifiers modifiers);
    bool popupOpen() const;
    /// True if an entry of the completion list is marked.
    bool chosenInPopup() const;
    void accept(const QModelIndex& index);
    /// Marks and shows what is wrong; without `all` it skips the word that is still being typed.
    Diagnostics check(bool all);
    void send();

    LineHistory history_;
    CommandLine* line_ = new CommandLine(this);
    QPushButton* send_ = new QPushButton(tr("Send"), this);
    QLabel* complaint_ = new QLabel(this);
    QCompleter* completer_ = new QCompleter(this);
    QStandardItemModel* completions_ = new QStandardItemModel(this);
    QTimer idle_{this};
    QString refusal_;
    QString sent_anyway_; ///< a second Enter sends this line in spite of its errors
};

} // namespace usar::widgets
