// The dock for faults in the simulator: set one up, inject it, end it.
#pragma once

#include <vector>

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

#include "core/base/clock.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

class EmptyState;
class QuantityBox;

/// A numeric parameter of a kind of fault, in the unit that the user sees.
struct FaultQuantity {
    /// Keyword of the text form, "speed".
    QString key;
    /// "m/s", "deg"; empty: none.
    QString unit;
    /// Limits of the editor.
    double smallest = 0.0;
    double largest = 0.0;
    /// Default; the text form leaves it out.
    double usual = 0.0;
    /// One sentence fragment, shown as a tooltip.
    QString help;
};

/// A kind of fault and the fields that its form shows.
struct FaultKindInfo {
    QString word; ///< keyword of the text form: "sensor_bias"
    QString help;
    bool of_robot = true;   ///< the form asks for a robot
    bool of_sensor = false; ///< the form asks for a sensor
    std::vector<FaultQuantity> quantities;
};

/// ToCome: injected, but its time has not come.
enum class FaultState { ToCome, Active, Over };

/// A fault of the running simulation, as the list shows it.
struct FaultRow {
    int id = 0;   ///< positive
    QString text; ///< the fault in text form, without its times
    FaultState state = FaultState::ToCome;
    QString when; ///< its times in words, shown as a tooltip; may be empty
    bool operator==(const FaultRow&) const = default;
};

/// The times of a fault in words. `lasts` may be infinite.
QString faultTimes(Seconds from, Seconds lasts);

/// Form that writes a fault as a line of text, which mission files also accept, and the list of the faults of this run.
/// State comes in by setters, wishes go out by signals. Made for a narrow dock. GUI thread.
class FaultPanel : public QWidget {
    Q_OBJECT
public:
    explicit FaultPanel(QWidget* parent = nullptr);

    /// The kinds to choose from.
    void setKinds(std::vector<FaultKindInfo> kinds);
    /// Names to choose from; the current choice stays if it is among them.
    void setRobots(const QStringList& names);
    /// Names to choose from; a chosen or typed name stays, even if it is not among them. Ignored while the user is
    /// typing there.
    void setSensors(const QStringList& names);
    /// Shows these faults, the last one at the top; a selected fault that still exists and is not over stays selected.
    void setFaults(const std::vector<FaultRow>& faults);
    /// Set to false if there is no simulator that could make faults; the empty state then says what to do.
    void setAvailable(bool on);

    /// The text form, "wind speed=5 from=60"; its times are seconds from now. Empty if there are no kinds.
    QString text() const;
    /// Id of the selected fault if it can still be ended; 0 if there is none.
    int endable() const;
    /// True if any listed fault is not over.
    bool anyToEnd() const;
    /// The sheet that covers the panel without an embedded simulator.
    EmptyState* emptyState() const { return empty_state_; }
    /// The buttons trigger these actions and follow their enabled state; the actions must outlive the panel.
    void setActions(QAction* inject, QAction* end);
    QSize sizeHint() const override { return {300, 480}; }

signals:
    /// The result of endable() may have changed.
    void selectionChanged();

private:
    /// The editor of a quantity of the shown kind.
    struct Field {
        QString key;
        QuantityBox* box = nullptr;
        double usual = 0.0;
    };

    /// Makes the fields that all kinds share: robot, sensor, beginning and duration.
    void makeForm();
    /// Makes the list of the faults of this run.
    void makeList();
    /// Colors the states in the list.
    void inkStates();
    /// Rebuilds the fields for the chosen kind.
    void showKind();
    /// Appends an editor with the quantity's limits and unit to the form.
    Field addNumber(const FaultQuantity& quantity);
    void showText() { text_->setText(text()); }

    std::vector<FaultKindInfo> kinds_;
    QComboBox* kind_ = new QComboBox;
    QLabel* help_ = mutedLabel();
    QFormLayout* form_;
    QComboBox* robot_ = new QComboBox;
    QComboBox* sensor_ = new QComboBox;
    QuantityBox* from_;
    QuantityBox* lasts_;
    std::vector<Field> fields_; ///< fields of the shown kind
    QLabel* text_ = new QLabel;
    QPushButton* inject_ = new QPushButton(tr("Inject fault"));
    QTreeWidget* list_ = new QTreeWidget;
    QPushButton* end_ = new QPushButton(tr("End fault"));
    EmptyState* empty_state_;
};

} // namespace usar::widgets
