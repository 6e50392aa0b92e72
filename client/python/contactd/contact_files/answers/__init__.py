"""What the CONTACT program tells of cases, from solutions of contactd."""
