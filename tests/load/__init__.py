"""The service under load: many clients at once, requests by the thousand, callers that leave."""
