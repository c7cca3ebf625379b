#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <tuple>

#include "src/simulation/trace/record.hpp"

namespace rubicon::trace {

/// A member of a record in the text, and the member of the struct that it is read into.
template <auto Member>
struct Field {
  std::string_view name;
  bool required = true;
};

template <auto Member>
constexpr Field<Member> required(std::string_view name) {
  return {name, true};
}
template <auto Member>
constexpr Field<Member> optional(std::string_view name) {
  return {name, false};
}

/// The table of records: the members of each kind besides `type`, `task` and `robot`, in the order
/// in which they are written. The reader decodes by it; a test holds the writer and
/// docs/trace.schema.json to it.
template <typename R>
struct RecordFields;

template <>
struct RecordFields<TaskStart> {
  static constexpr RecordKind kKind = RecordKind::task_start;
  static constexpr auto kFields =
      std::tuple(required<&TaskStart::t>("t"), optional<&TaskStart::because>("because"),
                 optional<&TaskStart::after>("after"), optional<&TaskStart::chosen>("chosen"),
                 optional<&TaskStart::to>("to"));
};

template <>
struct RecordFields<GoalStart> {
  static constexpr RecordKind kKind = RecordKind::goal;
  static constexpr auto kFields =
      std::tuple(required<&GoalStart::k>("k"), required<&GoalStart::n>("n"));
};

template <>
struct RecordFields<Assignment> {
  static constexpr RecordKind kKind = RecordKind::set;
  static constexpr auto kFields =
      std::tuple(required<&Assignment::variable>("var"), required<&Assignment::value>("value"));
};

template <>
struct RecordFields<LoopStart> {
  static constexpr RecordKind kKind = RecordKind::enter;
  static constexpr auto kFields =
      std::tuple(required<&LoopStart::kind>("kind"), required<&LoopStart::file>("file"),
                 required<&LoopStart::line>("line"), required<&LoopStart::column>("column"));
};

template <>
struct RecordFields<LoopEnd> {
  static constexpr RecordKind kKind = RecordKind::exit;
  static constexpr auto kFields = std::tuple(
      required<&LoopEnd::kind>("kind"), required<&LoopEnd::file>("file"),
      required<&LoopEnd::line>("line"), required<&LoopEnd::column>("column"),
      required<&LoopEnd::reached>("reached"), required<&LoopEnd::successes>("successes"));
};

template <>
struct RecordFields<Choice> {
  static constexpr RecordKind kKind = RecordKind::which;
  static constexpr auto kFields =
      std::tuple(required<&Choice::label>("label"), required<&Choice::file>("file"),
                 required<&Choice::line>("line"), required<&Choice::column>("column"));
};

template <>
struct RecordFields<Attempt> {
  static constexpr RecordKind kKind = RecordKind::attempt;
  static constexpr auto kFields =
      std::tuple(required<&Attempt::n>("n"), required<&Attempt::command>("command"),
                 required<&Attempt::parameters>("parameter"), required<&Attempt::file>("file"),
                 required<&Attempt::line>("line"), required<&Attempt::column>("column"),
                 required<&Attempt::ok>("ok"), required<&Attempt::reason>("reason"),
                 optional<&Attempt::hit>("hit"), optional<&Attempt::step>("step"),
                 required<&Attempt::t>("t"), required<&Attempt::q>("q"));
};

template <>
struct RecordFields<Wait> {
  static constexpr RecordKind kKind = RecordKind::wait;
  static constexpr auto kFields = std::tuple(required<&Wait::n>("n"), required<&Wait::t>("t"));
};

template <>
struct RecordFields<Work> {
  static constexpr RecordKind kKind = RecordKind::work;
  static constexpr auto kFields = std::tuple(
      required<&Work::what>("what"), required<&Work::crew>("crew"), required<&Work::from>("from"),
      required<&Work::t>("t"), required<&Work::time>("time"));
};

template <>
struct RecordFields<Pause> {
  static constexpr RecordKind kKind = RecordKind::pause;
  static constexpr auto kFields =
      std::tuple(required<&Pause::why>("why"), required<&Pause::whom>("for"),
                 required<&Pause::from>("from"), required<&Pause::t>("t"));
};

template <>
struct RecordFields<Attach> {
  static constexpr RecordKind kKind = RecordKind::attach;
  static constexpr auto kFields =
      std::tuple(required<&Attach::component>("component"), required<&Attach::X_TO>("pose"),
                 required<&Attach::t>("t"));
};

template <>
struct RecordFields<Detach> {
  static constexpr RecordKind kKind = RecordKind::detach;
  static constexpr auto kFields =
      std::tuple(required<&Detach::component>("component"), required<&Detach::X_WO>("pose"),
                 required<&Detach::t>("t"), optional<&Detach::overtime>("overtime"));
};

template <>
struct RecordFields<Removal> {
  static constexpr RecordKind kKind = RecordKind::remove;
  static constexpr auto kFields =
      std::tuple(required<&Removal::component>("component"), required<&Removal::t>("t"));
};

template <>
struct RecordFields<MotionEnd> {
  static constexpr RecordKind kKind = RecordKind::end;
  static constexpr auto kFields = std::tuple(
      required<&MotionEnd::status>("status"), required<&MotionEnd::reached>("reached"),
      required<&MotionEnd::period>("period"), required<&MotionEnd::tries>("tries"),
      required<&MotionEnd::accepted>("accepted"), required<&MotionEnd::rejected>("rejected"),
      required<&MotionEnd::residual>("residual"),
      optional<&MotionEnd::position_error>("position_error"),
      optional<&MotionEnd::orientation_error>("orientation_error"), required<&MotionEnd::q>("q"),
      required<&MotionEnd::variables>("vars"), required<&MotionEnd::t>("t"),
      optional<&MotionEnd::missed>("missed"), optional<&MotionEnd::missed_by>("missed_by"),
      optional<&MotionEnd::file>("file"), optional<&MotionEnd::line>("line"),
      optional<&MotionEnd::column>("column"), optional<&MotionEnd::message>("message"));
};

template <>
struct RecordFields<TaskEnd> {
  static constexpr RecordKind kKind = RecordKind::task_end;
  static constexpr auto kFields =
      std::tuple(required<&TaskEnd::t>("t"), required<&TaskEnd::result>("result"),
                 required<&TaskEnd::reason>("reason"), optional<&TaskEnd::driving>("driving"),
                 optional<&TaskEnd::serving>("serving"));
};

template <>
struct RecordFields<Stop> {
  static constexpr RecordKind kKind = RecordKind::stop;
  static constexpr auto kFields = std::tuple(required<&Stop::t>("t"));
};

template <>
struct RecordFields<Think> {
  static constexpr RecordKind kKind = RecordKind::think;
  static constexpr auto kFields =
      std::tuple(required<&Think::checks>("checks"), required<&Think::t>("t"));
};

template <>
struct RecordFields<GuidePlan> {
  static constexpr RecordKind kKind = RecordKind::guide;
  static constexpr auto kFields = std::tuple(
      required<&GuidePlan::name>("name"), required<&GuidePlan::kind>("kind"),
      required<&GuidePlan::seed>("seed"), required<&GuidePlan::found>("found"),
      optional<&GuidePlan::cause>("cause"), required<&GuidePlan::nodes>("nodes"),
      required<&GuidePlan::checks>("checks"), required<&GuidePlan::refused>("refused"),
      required<&GuidePlan::way>("way"), optional<&GuidePlan::events>("events"),
      optional<&GuidePlan::graph>("graph"), optional<&GuidePlan::legs>("legs"),
      required<&GuidePlan::roughness>("roughness"), required<&GuidePlan::length>("length"),
      required<&GuidePlan::motion_time>("motion_time"), required<&GuidePlan::t>("t"));
};

template <>
struct RecordFields<WayPoint> {
  static constexpr RecordKind kKind = RecordKind::way_point;
  static constexpr auto kFields =
      std::tuple(required<&WayPoint::k>("k"), required<&WayPoint::n>("n"));
};

template <>
struct RecordFields<Turn> {
  static constexpr RecordKind kKind = RecordKind::turn;
  static constexpr auto kFields =
      std::tuple(required<&Turn::component>("component"), required<&Turn::angle_deg>("angle"),
                 required<&Turn::X_TO>("pose"), required<&Turn::from>("from"),
                 required<&Turn::t>("t"), optional<&Turn::hit>("hit"));
};

template <>
struct RecordFields<Moving> {
  static constexpr RecordKind kKind = RecordKind::moving;
  static constexpr auto kFields =
      std::tuple(required<&Moving::name>("name"), required<&Moving::by>("by"),
                 required<&Moving::delay>("delay"), required<&Moving::t>("t"));
};

template <>
struct RecordFields<ColdJoint> {
  static constexpr RecordKind kKind = RecordKind::cold_joint;
  static constexpr auto kFields =
      std::tuple(required<&ColdJoint::ends>("ends"), required<&ColdJoint::age>("age"),
                 required<&ColdJoint::laid>("laid"), required<&ColdJoint::joined>("joined"),
                 required<&ColdJoint::t>("t"));
};

template <>
struct RecordFields<Breakdown> {
  static constexpr RecordKind kKind = RecordKind::breakdown;
  static constexpr auto kFields =
      std::tuple(required<&Breakdown::machine>("machine"), required<&Breakdown::during>("during"),
                 required<&Breakdown::every>("every"), required<&Breakdown::worked>("worked"),
                 required<&Breakdown::repair>("repair"), required<&Breakdown::t>("t"),
                 required<&Breakdown::until>("until"));
};

template <>
struct RecordFields<LostDays> {
  static constexpr RecordKind kKind = RecordKind::lost_days;
  static constexpr auto kFields =
      std::tuple(required<&LostDays::calendar>("calendar"), required<&LostDays::of>("of"),
                 required<&LostDays::days>("days"), required<&LostDays::t>("t"));
};

template <>
struct RecordFields<Soil> {
  static constexpr RecordKind kKind = RecordKind::soil;
  static constexpr auto kFields =
      std::tuple(required<&Soil::component>("component"), required<&Soil::volume>("volume"),
                 required<&Soil::cells>("cells"), required<&Soil::heights>("heights"),
                 required<&Soil::from>("from"), required<&Soil::t>("t"));
};

template <>
struct RecordFields<Foreseen> {
  static constexpr RecordKind kKind = RecordKind::foreseen;
  static constexpr auto kFields =
      std::tuple(required<&Foreseen::machine>("machine"), required<&Foreseen::seconds>("seconds"),
                 required<&Foreseen::corners>("corners"), required<&Foreseen::points>("points"),
                 required<&Foreseen::t>("t"));
};

template <>
struct RecordFields<Forbidden> {
  static constexpr RecordKind kKind = RecordKind::forbidden;
  static constexpr auto kFields =
      std::tuple(required<&Forbidden::parameters>("parameters"), required<&Forbidden::low>("low"),
                 required<&Forbidden::high>("high"), required<&Forbidden::cells>("cells"),
                 optional<&Forbidden::layers>("layers"), required<&Forbidden::at>("at"),
                 required<&Forbidden::runs>("runs"), required<&Forbidden::t>("t"));
};

/// What a member is in the text.
enum class FieldType {
  text,
  whole,  ///< from 0
  whole_or_null,
  number,
  number_or_null,
  truth,
  time,           ///< seconds
  names,          ///< a text or a list of texts
  numbers,        ///< a list of numbers
  pair,           ///< two texts
  configuration,  ///< an object of numbers
  values,         ///< an object of numbers or null
  counts,         ///< an object of whole numbers
  pose            ///< twelve numbers
};

/// The same table to look through.
struct FieldSpec {
  std::string_view name;
  bool required = true;
  FieldType type = FieldType::text;
};
struct RecordSpec {
  RecordKind kind = RecordKind::task_start;
  std::string_view type;
  std::span<const FieldSpec> fields;
};
std::span<const RecordSpec> record_table();

}  // namespace rubicon::trace
