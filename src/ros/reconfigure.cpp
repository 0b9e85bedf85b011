// SPDX-License-Identifier: BSD-3-Clause
#include "reconfigure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "callbacks.hpp"
#include "core/option_number.hpp"
#include "reconfigure_fields.hpp"

namespace adaptive_localization {
namespace {

/// Other text is no name in ROS, and the parameter server does not take it.
void checkText(const std::string& key, const OptionValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~'; };
  if (text && !std::all_of(text->begin(), text->end(), is_plain)) {
    throw std::invalid_argument("field '" + key + "': got '" + *text +
                                "', expected printable characters of ASCII alone");
  }
}

/// The nearest value that an option takes, of its type. Throws std::invalid_argument if none is.
OptionValue nearestFor(const OptionDescription& field, const OptionValue& value) {
  const bool whole = std::holds_alternative<int>(field.value);
  if (!isNumber(field.value)) {
    checkText(field.key, value);
    if (field.value.index() == value.index()) return value;
  } else if (isNumber(value) && !std::isnan(numberOf(value))) {
    const double most = whole ? std::numeric_limits<int>::max() : field.range.high;
    const double number =
        std::clamp(numberOf(value), field.range.low, std::min(field.range.high, most));
    return whole ? OptionValue{static_cast<int>(std::lround(number))} : OptionValue{number};
  }
  throw std::invalid_argument("field '" + field.key + "': got '" + toText(value) +
                              "', which is of another type");
}

}  // namespace

Reconfigure::Reconfigure(const ros::NodeHandle& private_node, ParameterWriter& server,
                         const Parameters& given, Apply apply)
    : node_(private_node),
      server_(server),
      apply_(std::move(apply)),
      at_start_(given),
      given_(given) {
  descriptions_ =
      node_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true);
  updates_ = node_.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, true);
  this->apply(given);
  publish();
  service_ = serve<Service>(node_, "set_parameters", [this](auto& request, auto& response) {
    return onRequest(request, response);
  });
}

Reconfigure::~Reconfigure() {
  for (const auto& entry : written_) {
    if (!given_.has(entry.first)) server_.remove(entry.first);
  }
}

bool Reconfigure::onRequest(Service::Request& request, Service::Response& response) {
  try {
    change(valuesOf(request.config));
  } catch (...) {  // a plug-in may throw anything
    ROS_WARN("Options stay as they were: %s", errorText().c_str());
    apply(given_);
  }
  publish();
  response.config = toConfig(fields_);
  return true;
}

void Reconfigure::change(const Values& values) {
  const auto restore = values.find("restore_defaults");
  if (restore != values.end() && restore->second == OptionValue{true}) {
    apply(at_start_);
    given_ = at_start_;
    return;
  }
  const Values wanted = understood(values);
  Parameters parameters = given_;
  for (const auto& [key, value] : wanted) {
    if (find(key)->value != value) parameters.set(key, value);
  }
  apply(parameters);
  // Another core or preset has other values where none is given: those asked for are given now.
  for (const auto& [key, value] : wanted) {
    if (find(key)->value != value) parameters.set(key, value);
  }
  apply(parameters);
  given_ = parameters;
}

/// The values of fields, in range; as in amcl, max_particles is at least min_particles.
Values Reconfigure::understood(const Values& values) const {
  Values wanted;
  for (const auto& [key, value] : values) {
    const OptionDescription* field = find(key);
    if (!field) {
      ROS_WARN("There is no field '%s'", key.c_str());
      continue;
    }
    wanted[key] = nearestFor(*field, value);
    if (isNumber(value) && numberOf(wanted[key]) != numberOf(value)) {
      ROS_WARN("Field '%s': got %s, taken as %s", key.c_str(), toText(value).c_str(),
               toText(wanted[key]).c_str());
    }
    if (isReadAtStart(key) && wanted[key] != field->value) {
      ROS_WARN("Field '%s' takes effect at the next start", key.c_str());
    }
  }
  wanted.erase("restore_defaults");
  if (!wanted.count("min_particles") && !wanted.count("max_particles")) return wanted;
  const auto limit = [&](const std::string& key) {
    return wanted.count(key) ? wanted[key] : find(key)->value;
  };
  if (numberOf(limit("min_particles")) > numberOf(limit("max_particles"))) {
    wanted["max_particles"] = limit("min_particles");
    ROS_WARN("min_particles is above max_particles, which is set to the same: %s",
             toText(wanted["max_particles"]).c_str());
  }
  return wanted;
}

const OptionDescription* Reconfigure::find(const std::string& key) const {
  const auto found = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const OptionDescription& field) { return field.key == key; });
  return found == fields_.end() ? nullptr : &*found;
}

void Reconfigure::apply(const Parameters& parameters) {
  auto amcl = parameters.read<AmclFields>();
  amcl.restore_defaults = false;
  fields_ = fieldsOf(apply_(parameters), amcl);
}

void Reconfigure::publish() {
  if (described_ != fields_.size()) descriptions_.publish(toDescription(fields_));
  described_ = fields_.size();
  updates_.publish(toConfig(fields_));
  for (const auto& field : fields_) {
    const auto before = written_.find(field.key);
    if (before != written_.end() && before->second == field.value) continue;
    server_.set(field.key, field.value);
    written_[field.key] = field.value;
  }
}

}  // namespace adaptive_localization
