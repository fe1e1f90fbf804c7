// Which types of lines are shown: a button that says the choice, and a list of the types seen, with boxes to tick.
#pragma once

#include <functional>

#include <QListWidget>
#include <QToolButton>

#include "widgets/models/message_filter.h"

namespace usar::widgets {

/// The list opens below the button and stays open while boxes are ticked. GUI thread.
class TypeChoiceButton : public QToolButton {
    Q_OBJECT
public:
    /// How many lines of each type there are, asked when the list opens.
    using Counts = std::map<std::string, int, std::less<>>;

    explicit TypeChoiceButton(QWidget* parent = nullptr);

    void setCounts(std::function<Counts()> counts) { counts_ = std::move(counts); }
    const TypeChoice& choice() const { return choice_; }
    /// Emits nothing.
    void setChoice(const TypeChoice& choice);
    /// Types seen, and those chosen before, with their boxes.
    void openList();
    QListWidget* list() const { return list_; }
    QSize sizeHint() const override;

signals:
    void choiceChanged();

private:
    QWidget* makePopup();
    void fill();
    void choose(const TypeChoice& choice);
    void takeTick(const QListWidgetItem* item);
    void showChoice();

    std::function<Counts()> counts_;
    TypeChoice choice_;
    QListWidget* list_ = nullptr; ///< made with the popup
    QWidget* popup_;
};

} // namespace usar::widgets
